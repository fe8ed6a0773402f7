#include <cmath>

#include <fmt/format.h>

#include "record/summary.hpp"

namespace percuss {
namespace {

std::string promise(const Expectation& expectation) {
    const bool above = std::isfinite(expectation.min), below = std::isfinite(expectation.max);
    if (above && below) {
        const double half = 0.5 * (expectation.max - expectation.min);
        const double middle = 0.5 * (expectation.max + expectation.min);
        return half == 0 ? fmt::format("{:.6g}", middle) : fmt::format("{:.6g} +- {:.3g}", middle, half);
    }
    if (above) return fmt::format("at least {:.6g}", expectation.min);
    return fmt::format("at most {:.6g}", expectation.max);
}

}  // namespace

std::optional<double> summary_value(const nlohmann::ordered_json& summary, std::string_view path) {
    if (!summary.is_object()) return std::nullopt;
    for (const auto& [key, value] : summary.items()) {
        if (!path.starts_with(key)) continue;
        if (path.size() == key.size()) {
            if (value.is_number()) return value.get<double>();
        } else if (path[key.size()] == '.') {
            if (const auto found = summary_value(value, path.substr(key.size() + 1))) return found;
        }
    }
    return std::nullopt;
}

std::vector<ExpectationResult> check_expectations(const Scene& scene, const nlohmann::ordered_json& summary) {
    std::vector<ExpectationResult> results;
    for (const Expectation& expectation : scene.expect) {
        const std::optional<double> value = summary_value(summary, expectation.path);
        const bool kept = value && *value >= expectation.min && *value <= expectation.max;
        const std::string reason = expectation.why.empty() ? "" : fmt::format(" ({})", expectation.why);
        results.push_back(
            {kept, fmt::format("{} is {}, promised {}{}", expectation.path,
                               value ? fmt::format("{:.6g}", *value) : "missing from the summary",
                               promise(expectation), reason)});
    }
    return results;
}

std::vector<std::string> broken_expectations(const Scene& scene, const nlohmann::ordered_json& summary) {
    std::vector<std::string> broken;
    for (const ExpectationResult& result : check_expectations(scene, summary)) {
        if (!result.kept) broken.push_back(result.text);
    }
    return broken;
}

}  // namespace percuss
