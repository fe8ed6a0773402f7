#include "scheme_cases.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "exit_status.hpp"
#include "interrupt.hpp"
#include "nearest_name.hpp"
#include "record/summary.hpp"
#include "scene/named_schemes.hpp"
#include "scene/parse.hpp"
#include "session.hpp"

namespace percuss::app {
namespace {

/// A step or value that all schemes are run with.
struct Variant {
    std::string label;
    std::vector<std::string> overrides;
};

std::vector<Variant> variants_of(const SchemeGrid& grid) {
    std::vector<Variant> variants{{}};
    const auto multiply = [&](const std::vector<Variant>& by) {
        if (by.empty()) return;
        std::vector<Variant> product;
        for (const Variant& a : variants)
            for (const Variant& b : by) {
                Variant both = a;
                both.label += (a.label.empty() ? "" : ", ") + b.label;
                both.overrides.insert(both.overrides.end(), b.overrides.begin(), b.overrides.end());
                product.push_back(std::move(both));
            }
        variants = std::move(product);
    };
    std::vector<Variant> steps, values;
    for (const double step : grid.steps)
        steps.push_back({fmt::format("Δt {:g}", step), {fmt::format("model.step.courant={}", step)}});
    const std::string name = grid.key.substr(grid.key.rfind('.') + 1);
    for (const std::string& value : grid.values)
        values.push_back({fmt::format("{} {}", name, value), {grid.key + "=" + value}});
    multiply(values);
    multiply(steps);
    return variants;
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
        const auto found =
            std::find_if(choices.begin(), choices.end(), [&](const auto& c) { return c.name == name; });
        if (found == choices.end())
            throw UsageError(
                fmt::format("--schemes: unknown scheme '{}'{}", name, suggest_name(name, scheme_names())));
        if (!found->fault.empty())
            throw UsageError(
                fmt::format("--schemes: the scene cannot take the scheme '{}': {}", name, found->fault));
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
    std::vector<SchemeCase> cases;
    for (const Variant& variant : variants_of(grid))
        for (const std::string& scheme : schemes) {
            std::vector<std::string> all = overrides;
            for (const std::string& setting : scheme_overrides(*find_scheme(scheme), scene))
                all.push_back(setting);
            all.insert(all.end(), variant.overrides.begin(), variant.overrides.end());
            const bool alone = schemes.size() == 1 && !variant.label.empty();
            const std::string label = alone                   ? variant.label
                                      : variant.label.empty() ? scheme
                                                              : scheme + ", " + variant.label;
            cases.push_back({load_scene(file, all), scheme, variant.label, label});
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
