#include "run/contact_forces.hpp"

#include <algorithm>
#include <cmath>

#include "run/fields.hpp"
#include "run/series.hpp"

namespace percuss {

namespace {

std::optional<std::size_t> find_column(const History& history, const std::string& name) {
    const auto& columns = history.columns();
    const auto found =
        std::find_if(columns.begin(), columns.end(), [&](const HistoryColumn& c) { return c.name == name; });
    if (found == columns.end()) return std::nullopt;
    return static_cast<std::size_t>(found - columns.begin());
}

}  // namespace

ContactAnalysis analyse_contacts(const Scene& scene, const History& history) {
    constexpr double windows_in_a_run = 200;
    ContactAnalysis analysis;
    const std::vector<double> times = history.values("time");
    analysis.window = scene.analysis.window.value_or(scene.duration / windows_in_a_run);
    analysis.residual_to = times.back();
    analysis.residual_from = times.back() - scene.analysis.residual * (times.back() - times.front());
    const auto directions = direction_names(scene.geometry);
    const auto means_of = [&](const std::string& name, const std::string& columns) {
        ForceMeans means{name};
        for (std::size_t d = 0; d < 2; ++d) {
            const auto column = find_column(history, columns + directions[d]);
            if (!column) continue;
            // Rows that came since `times` was read belong to no time of it.
            std::vector<double> force = history.values(*column, 0, times.size());
            means.residual[d] = mean_between(times, force, analysis.residual_from, analysis.residual_to);
            force = moving_average(times, force, analysis.window);
            const std::size_t peak = largest_magnitude(force);
            means.peak[d] = force[peak];
            means.peak_time[d] = times[peak];
        }
        return means;
    };
    for (const ContactPair& pair : scene.contacts)
        analysis.pairs.push_back(means_of(pair.name, "contact." + pair.name + "."));
    for (const Body& body : scene.bodies)
        if (!body.prescribed.empty())
            analysis.drives.push_back(means_of(body.name, "body." + body.name + ".drive."));
    return analysis;
}

std::optional<PullOutEstimate> estimate_pull_out(const Scene& scene, const ContactAnalysis& contacts) {
    if (!scene.analysis.pull_out) return std::nullopt;
    const Analysis::PullOut& asked = *scene.analysis.pull_out;
    PullOutEstimate estimate;
    estimate.friction = asked.friction;
    for (std::size_t p = 0; p < contacts.pairs.size(); ++p) {
        const ContactPair& pair = scene.contacts[p];
        const bool touches = pair.master.body == asked.body || pair.slave.body == asked.body;
        const bool wanted = asked.pairs.empty() ||
                            std::find(asked.pairs.begin(), asked.pairs.end(), pair.name) != asked.pairs.end();
        if (!touches || !wanted) continue;
        const double normal = std::abs(contacts.pairs[p].residual[0]);
        estimate.parts.emplace_back(pair.name, normal);
        estimate.normal_force += normal;
    }
    estimate.force = estimate.friction * estimate.normal_force;
    return estimate;
}

}  // namespace percuss
