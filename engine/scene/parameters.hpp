#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <toml++/toml.h>

#include "scene/faults.hpp"
#include "scene/formula.hpp"
#include "scene/scene.hpp"

namespace percuss {

class Expression;

/// The [parameters] of a scene, and the value of any expression of them. Each parameter is evaluated when it
/// is first asked for, so that they may stand in any order; faults are told once, those that follow from them
/// never.
class Parameters {
  public:
    /// @param declared the table [parameters], or null. It must outlive this.
    Parameters(const toml::table* declared, Faults& faults);

    /// True for the text of an expression: "= 2*shank".
    [[nodiscard]] static bool is_expression(std::string_view text) { return text.starts_with('='); }
    /// Value of an expression. @param what how messages call the number. Nothing when it is faulty.
    [[nodiscard]] std::optional<double> evaluate(const std::string& text, const Place& place,
                                                 const std::string& what);
    /// A formula of the variables and of parameters. Nothing when it is faulty.
    [[nodiscard]] std::optional<Formula> formula(const std::string& text, const Place& place,
                                                 const std::string& what,
                                                 const std::vector<std::string>& variables);
    /// Reads all parameters, those that nothing uses too, in the order of the file.
    [[nodiscard]] std::vector<Parameter> all();

  private:
    enum class State { unread, reading, good, faulty };
    struct Entry {
        const toml::node* node = nullptr;
        Place key;
        State state = State::unread;
        Parameter parameter;
    };
    std::optional<double> value(Entry& entry);
    bool read(Entry& entry);
    std::optional<Expression> compile(const std::string& text, const Place& place, const std::string& what,
                                      const std::vector<std::string>& variables,
                                      std::vector<std::pair<std::string, double>>& values);

    Faults* faults_;
    std::map<std::string, Entry, std::less<>> entries_;
    std::vector<std::string> reading_;  // parameters whose expressions are being evaluated, outermost first
};

}  // namespace percuss
