#pragma once

#include <string>
#include <utility>
#include <vector>

#include "scene/scene.hpp"

namespace percuss {

/// Collects what is wrong with a scene while reading goes on, so that one run of the parser tells all.
class Faults {
  public:
    Faults(std::string file, std::vector<std::string> overrides);

    void error(const Place& place, std::string message);
    void warning(const Place& place, std::string message);
    /// True when so many errors are collected that more would not be read.
    [[nodiscard]] bool full() const { return errors_.size() >= most; }
    [[nodiscard]] bool any() const { return !errors_.empty(); }
    /// @throws SceneError with all errors in the order of the file, those of overrides last.
    void throw_if_any() const;
    /// Warnings in the order of the file, each with its place.
    [[nodiscard]] std::vector<std::string> warnings() const;

  private:
    using Message = std::pair<Place, std::string>;
    static constexpr std::size_t most = 50;
    [[nodiscard]] std::vector<std::string> in_order(const std::vector<Message>& messages) const;

    std::string file_;
    std::vector<std::string> overrides_;
    std::vector<Message> errors_, warnings_;
};

/// As describe_place of parse.hpp, for a scene that is still being read.
[[nodiscard]] std::string describe_place(const std::string& file, const std::vector<std::string>& overrides,
                                         const Place& place);

}  // namespace percuss
