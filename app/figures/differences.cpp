#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "figures/comparison.hpp"
#include "record/summary.hpp"

namespace percuss::app {
namespace {

using Json = nlohmann::ordered_json;

bool begins(const std::string& text, std::string_view with) { return text.starts_with(with); }
bool holds(const std::string& text, std::string_view part) { return text.find(part) != std::string::npos; }

/// The unit of a number of summary.json; nothing when it is none that two designs are compared by.
std::optional<std::string> unit_of(const std::string& path, const Scene& scene) {
    const auto label = [&](Quantity quantity) { return scene.units.label(quantity); };
    if (begins(path, "parameters.")) {
        for (const Parameter& parameter : scene.parameters)
            if (path == "parameters." + parameter.name) return parameter.unit;
        return "";
    }
    if (path == "steps" || path == "elements") return "";
    if (path == "critical_step") return label(Quantity::time);
    if (begins(path, "contact.") || holds(path, ".drive.")) {
        if (holds(path, ".peak_averaged.") || holds(path, ".residual.")) return label(Quantity::force);
        if (holds(path, ".peak_averaged_time.")) return label(Quantity::time);
        if (holds(path, ".impulse.")) return label(Quantity::impulse);
        if (path.ends_with(".max_penetration")) return label(Quantity::length);
    }
    if (begins(path, "body.")) {
        if (holds(path, ".velocity.")) return label(Quantity::velocity);
        if (holds(path, ".extent.")) return label(Quantity::length);
        if (path.ends_with(".plastic_strain_max")) return "";
    }
    if (begins(path, "energy_budget.") || path == "energy.initial") return label(Quantity::energy);
    if (path == "energy.maximum_loss" || path == "energy.maximum_growth") return "";
    if (path == "analysis.pull_out.force" || path == "analysis.pull_out.normal_force")
        return label(Quantity::force);
    return std::nullopt;
}

void collect(const Json& a, const Json& b, const std::string& path, const Scene& scene,
             std::vector<Difference>& found) {
    if (a.is_object() && b.is_object()) {
        for (const auto& [key, value] : a.items()) {
            const auto other = b.find(key);
            if (other != b.end()) collect(value, *other, path.empty() ? key : path + "." + key, scene, found);
        }
        return;
    }
    if (!a.is_number() || !b.is_number()) return;
    if (const auto unit = unit_of(path, scene))
        found.push_back({path, *unit, a.get<double>(), b.get<double>()});
}

}  // namespace

double Difference::relative() const {
    if (a == b) return 0;
    if (a == 0) return std::numeric_limits<double>::infinity();
    return b / a - 1;
}

std::vector<Difference> compare_runs(const RecordedRun& a, const RecordedRun& b) {
    std::vector<Difference> found;
    collect(a.summary, b.summary, "", a.setup->scene, found);
    // The answer to "what is the design good for" right after what was changed.
    std::stable_partition(found.begin(), found.end(), [](const Difference& d) {
        return d.path.starts_with("parameters.") || d.path.starts_with("analysis.");
    });
    return found;
}

std::string differences_csv(const std::vector<Difference>& differences) {
    std::string csv = "quantity,unit,a,b,difference,relative\n";
    for (const Difference& d : differences)
        csv += fmt::format("{},{},{:.10g},{:.10g},{:.6g},{:.6g}\n", d.path, d.unit, d.a, d.b, d.b - d.a,
                           d.relative());
    return csv;
}

}  // namespace percuss::app
