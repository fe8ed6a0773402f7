#include "record/analysis_summary.hpp"

#include "run/contact_forces.hpp"
#include "run/energy_budget.hpp"
#include "run/fields.hpp"

namespace percuss {
namespace {

using Json = nlohmann::ordered_json;

Json by_direction(const Scene& scene, const std::array<double, 2>& values) {
    const auto names = direction_names(scene.geometry);
    return {{names[0], values[0]}, {names[1], values[1]}};
}

Json pull_out(const Scene& scene, const PullOutEstimate& estimate) {
    Json pairs = Json::object();
    for (const auto& [pair, force] : estimate.parts) pairs[pair] = force;
    const std::string direction = direction_names(scene.geometry)[0];
    return {{"body", scene.analysis.pull_out->body},
            {"force", estimate.force},
            {"friction", estimate.friction},
            {"normal_force", estimate.normal_force},
            {"normal_force_by_pair", pairs},
            {"formula", "force = friction * sum over pairs of |contact.PAIR.residual." + direction + "|"}};
}

}  // namespace

Json analyse(const Scene& scene, const History& history, Json& contacts, Json& bodies) {
    Json result = Json::object();
    if (history.rows() < 2) return result;
    const ContactAnalysis analysis = analyse_contacts(scene, history);
    if (analysis.pairs.empty() && analysis.drives.empty()) return result;
    const auto put = [&](Json& to, const ForceMeans& means) {
        to["peak_averaged"] = by_direction(scene, means.peak);
        to["peak_averaged_time"] = by_direction(scene, means.peak_time);
        to["residual"] = by_direction(scene, means.residual);
    };
    for (const ForceMeans& pair : analysis.pairs) put(contacts[pair.name], pair);
    for (const ForceMeans& drive : analysis.drives) put(bodies[drive.name]["drive"], drive);
    result["window"] = analysis.window;
    result["residual_from"] = analysis.residual_from;
    result["residual_to"] = analysis.residual_to;
    if (const auto estimate = estimate_pull_out(scene, analysis))
        result["pull_out"] = pull_out(scene, *estimate);
    return result;
}

Json budget_summary(const Snapshot& last) {
    Json result = Json::object();
    for (const EnergyShare& share : energy_budget(last)) {
        if (share.body.empty())
            result[share.kind] = share.energy;
        else
            result[share.kind][share.body] = share.energy;
    }
    if (!result.empty()) result["put_in"] = last.energy.external;
    return result;
}

}  // namespace percuss
