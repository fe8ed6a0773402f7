#include "scheme_cases.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "exit_status.hpp"
#include "interrupt.hpp"
#include "record/summary.hpp"
#include "scene/named_schemes.hpp"
#include "scene/parse.hpp"
#include "session.hpp"
#include "study/grid.hpp"

namespace percuss::app {
namespace {

/// The grid as axes: values, steps, schemes.
std::vector<Variation> axes_of(const SchemeGrid& grid, const Scene& scene,
                               const std::vector<std::string>& schemes) {
    std::vector<Variation> axes;
    const auto add = [&](std::string key, std::vector<std::string> values) {
        StudyAxis axis{std::move(key), std::move(values), "", AxisKind::design, {}};
        axis.name = usual_name(axis.key);
        axis.kind = usual_kind(axis.key);
        if (!axis.values.empty()) axes.push_back(make_variation(axis, scene));
    };
    add(grid.key, grid.values);
    std::vector<std::string> steps;
    for (const double step : grid.steps) steps.push_back(fmt::format("{}", step));
    add("model.step.courant", steps);
    add("scheme", schemes);
    return axes;
}

/// "mesh 10, Δt 0.5"
std::string variant_label(const std::vector<Variation>& axes, const Combination& one) {
    std::string label;
    for (std::size_t a = 0; a + 1 < axes.size(); ++a)
        label += fmt::format("{}{} {}", label.empty() ? "" : ", ",
                             axes[a].axis.key == "model.step.courant" ? "Δt" : axes[a].axis.name,
                             axes[a].values[one.at[a]].label);
    return label;
}

std::vector<std::string> schemes_for(const Scene& scene, const std::vector<std::string>& wanted) {
    const std::vector<SchemeChoice> choices = scheme_choices(scene);
    std::vector<std::string> schemes;
    if (wanted.empty()) {
        for (const SchemeChoice& choice : choices)
            if (choice.fault.empty()) schemes.push_back(choice.name);
        return schemes;
    }
    for (const std::string& name : wanted) {
        static_cast<void>(choose_scheme(choices, name, "--schemes"));
        if (std::find(schemes.begin(), schemes.end(), name) == schemes.end()) schemes.push_back(name);
    }
    return schemes;
}

}  // namespace

std::vector<SchemeCase> make_cases(const std::string& file, const std::vector<std::string>& overrides,
                                   const SchemeGrid& grid) {
    const Scene scene = load_scene(file, overrides);
    if (scene.contacts.empty())
        throw UsageError(fmt::format("{}: the scene has no [[contact]]; there is no scheme to choose", file));
    const std::vector<std::string> schemes = schemes_for(scene, grid.schemes);
    const std::vector<Variation> axes = axes_of(grid, scene, schemes);
    std::vector<SchemeCase> cases;
    for (const Combination& one : combine(axes)) {
        std::vector<std::string> all = overrides;
        all.insert(all.end(), one.overrides.begin(), one.overrides.end());
        const std::string variant = variant_label(axes, one),
                          scheme = axes.back().values[one.at.back()].label;
        const std::string label = variant.empty()       ? scheme
                                  : schemes.size() == 1 ? variant
                                                        : scheme + ", " + variant;
        cases.push_back({load_scene(file, all), scheme, variant, label});
    }
    return cases;
}

std::optional<CaseRun> run_case(const SchemeCase& of, int threads) {
    using namespace std::chrono_literals;
    const InterruptGuard guard;
    Session session(of.scene, of.scene.duration, threads);
    session.start();
    while (!session.frames().drained()) {
        static_cast<void>(session.frames().pop(20ms));
        if (!InterruptGuard::requested()) continue;
        session.interrupt();
        return std::nullopt;
    }
    const auto last = session.engine().snapshot();
    CaseRun result;
    result.scheme = of.scheme;
    result.variant = of.variant;
    result.diverged = last->status == RunStatus::diverged;
    result.run.label = of.label;
    result.run.setup = last->setup;
    result.run.history = session.engine().history();
    result.run.summary =
        make_summary(*last->setup, session.engine().statistics(), *result.run.history, *last);
    return result;
}

}  // namespace percuss::app
