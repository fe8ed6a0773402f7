#include "study/accuracy.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "exit_status.hpp"
#include "study/evaluation.hpp"
#include "study/run_cases.hpp"
#include "study/study_table.hpp"

namespace percuss::app {
namespace {

bool refines(const StudyAxis& axis) { return axis.kind == AxisKind::step || axis.kind == AxisKind::mesh; }

/// Whether steps or meshes are left to choose from by what is set.
bool has_choice(const Scene& scene) {
    return std::any_of(scene.study->vary.begin(), scene.study->vary.end(), [&](const StudyAxis& axis) {
        return refines(axis) && !is_set(axis, scene.overrides);
    });
}

/// The grid of the scene's study where everything but steps and meshes is home. Its cases keep their keys, so
/// that what a study has left counts.
Study steps_and_meshes(const Scene& scene) {
    StudyRequest request;
    request.file = scene.file;
    request.overrides = scene.overrides;
    const auto& quantities = scene.study->quantities;
    const auto is_target = [&](const StudyQuantity& q) { return q.of == scene.accuracy->quantity; };
    if (std::none_of(quantities.begin(), quantities.end(), is_target))
        request.quantities = {scene.accuracy->quantity};
    Study study = make_study(request);
    std::erase_if(study.cases, [&](const StudyCase& each) {
        for (std::size_t a = 0; a < study.axes.size(); ++a)
            if (!refines(study.axes[a].axis) && each.at[a] != study.axes[a].home()) return true;
        return false;
    });
    return study;
}

}  // namespace

std::optional<AccuracyChoice> choose_accuracy(const Scene& scene, bool& interrupted) {
    if (!has_choice(scene)) return std::nullopt;
    const Study study = steps_and_meshes(scene);
    const StudyFolder folder = usual_study_folder(scene.file);
    folder.check(false);
    const auto results = run_cases(study, folder, {});
    if (!results) {
        interrupted = true;
        return std::nullopt;
    }
    const Evaluation evaluation = evaluate(study, *results);
    std::size_t q = 0;
    while (study.quantities[q].of != scene.accuracy->quantity) ++q;
    std::vector<Offer> offers;
    for (std::size_t i = 0; i < study.cases.size(); ++i)
        offers.push_back({(*results)[i].best_seconds(), evaluation.errors[i][q]});
    const double tolerance = scene.accuracy->tolerance;
    auto best = cheapest_within(offers, tolerance);
    AccuracyChoice choice;
    choice.within = best.has_value();
    for (std::size_t i = 0; !choice.within && i < offers.size(); ++i)
        if (offers[i].error && (!best || *offers[i].error < *offers[*best].error)) best = i;
    if (!best)
        throw UsageError(fmt::format(
            "[accuracy]: no case finished with an error of '{}' to judge it by; 'percuss study {}' tells why",
            scene.accuracy->quantity, scene.file));
    std::string label;
    for (std::size_t a = 0; a < study.axes.size(); ++a) {
        if (!refines(study.axes[a].axis)) continue;
        const std::size_t value = study.cases[*best].at[a];
        const auto& settings = study.axes[a].values[value].overrides;
        choice.overrides.insert(choice.overrides.end(), settings.begin(), settings.end());
        label += (label.empty() ? "" : ", ") + study.axes[a].describe(value);
    }
    const Reference& reference = evaluation.designs.front().references[q];
    const std::string against = reference.exact
                                    ? reference.how
                                    : fmt::format("{}, ± {}", reference.how, percent(reference.uncertainty));
    choice.text = fmt::format(
        "accuracy: {}, of {} cases: {} is {} off in {}, against: {}; {}", label, offers.size(),
        study.quantities[q].name, percent(*offers[*best].error), time_text(offers[*best].price), against,
        choice.within ? fmt::format("{} is allowed", percent(tolerance))
                      : fmt::format("none is within {}, this is the nearest", percent(tolerance)));
    choice.record = {{"quantity", scene.accuracy->quantity},
                     {"tolerance", tolerance},
                     {"within", choice.within},
                     {"chosen", label},
                     {"error", *offers[*best].error},
                     {"seconds", offers[*best].price},
                     {"reference", reference.how},
                     {"cases", offers.size()}};
    if (!reference.exact) choice.record["reference_uncertainty"] = reference.uncertainty;
    return choice;
}

}  // namespace percuss::app
