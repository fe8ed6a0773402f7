#include "scene/faults.hpp"

#include <algorithm>
#include <tuple>

#include <fmt/format.h>

#include "scene/parse.hpp"

namespace percuss {
namespace {

std::string joined(const std::vector<std::string>& lines) {
    std::string text;
    for (const auto& line : lines) text += (text.empty() ? "" : "\n") + line;
    return text;
}

}  // namespace

SceneError::SceneError(std::vector<std::string> messages)
    : std::runtime_error(joined(messages)), messages_(std::move(messages)) {}

std::string describe_place(const std::string& file, const std::vector<std::string>& overrides,
                           const Place& place) {
    const auto number = static_cast<std::size_t>(std::max(place.override_number, 0));
    if (number > 0 && number <= overrides.size()) return "--set " + overrides[number - 1];
    if (place.line == 0) return file;
    return fmt::format("{}:{}:{}", file, place.line, place.column);
}

std::string describe_place(const Scene& scene, const Place& place) {
    return describe_place(scene.file, scene.overrides, place);
}

Faults::Faults(std::string file, std::vector<std::string> overrides)
    : file_(std::move(file)), overrides_(std::move(overrides)) {}

void Faults::error(const Place& place, std::string message) {
    if (errors_.size() == most) message = "there are more faults; these are the first that were found";
    if (errors_.size() <= most) errors_.emplace_back(place, std::move(message));
}

void Faults::warning(const Place& place, std::string message) {
    if (warnings_.size() < most) warnings_.emplace_back(place, "warning: " + std::move(message));
}

void Faults::throw_if_any() const {
    if (any()) throw SceneError(in_order(errors_));
}

std::vector<std::string> Faults::warnings() const { return in_order(warnings_); }

std::vector<std::string> Faults::in_order(const std::vector<Message>& messages) const {
    auto sorted = messages;
    std::stable_sort(sorted.begin(), sorted.end(), [](const Message& a, const Message& b) {
        const auto key = [](const Place& p) { return std::tuple(p.override_number, p.line, p.column); };
        return key(a.first) < key(b.first);
    });
    std::vector<std::string> lines;
    for (const auto& [place, message] : sorted)
        lines.push_back(describe_place(file_, overrides_, place) + ": " + message);
    return lines;
}

}  // namespace percuss
