#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "study/study_table.hpp"

namespace percuss::app {
namespace {

/// A case along one axis that can be judged.
struct Rung {
    std::size_t place = 0;  ///< of the case
    std::string label;      ///< "step 0.9"
    double error = 0, seconds = 0;
};

class Speaker {
  public:
    Speaker(const Study& study, const std::vector<CaseResult>& results, const Evaluation& evaluation)
        : study_(study), results_(results), evaluation_(evaluation) {}

    std::vector<std::string> speak() {
        for (const Design& design : evaluation_.designs) {
            const std::string prefix = design.label.empty() ? "" : design.label + ": ";
            for (std::size_t a = 0; a < study_.axes.size(); ++a) {
                const Variation& axis = study_.axes[a];
                if (axis.values.size() < 2 || axis.axis.kind == AxisKind::design) continue;
                if (axis.axis.kind == AxisKind::method)
                    methods(design, a, prefix);
                else
                    ends(design, a, prefix);
            }
            own_settings(design, prefix);
        }
        return std::move(sentences_);
    }

  private:
    [[nodiscard]] std::vector<std::size_t> home(const Design& design) const {
        std::vector<std::size_t> at = study_.cases[design.cases.front()].at;
        for (std::size_t a = 0; a < study_.axes.size(); ++a)
            if (study_.axes[a].axis.kind != AxisKind::design) at[a] = study_.axes[a].home();
        return at;
    }

    [[nodiscard]] std::string value_label(std::size_t axis, std::size_t value) const {
        const bool fraction = study_.axes[axis].axis.key == "model.step.courant";
        return study_.axes[axis].describe(value) + (fraction ? " of critical" : "");
    }

    /// Where the other axes stand, "" when there are none.
    [[nodiscard]] std::string elsewhere(const std::vector<std::size_t>& at, std::size_t axis) const {
        std::string text;
        for (std::size_t a = 0; a < study_.axes.size(); ++a)
            if (a != axis && study_.axes[a].values.size() > 1 && study_.axes[a].axis.kind != AxisKind::design)
                text += (text.empty() ? " (" : ", ") + value_label(a, at[a]);
        return text.empty() ? "" : text + ")";
    }

    void own_settings(const Design& design, const std::string& prefix) {
        const std::size_t own = case_at(study_, home(design));
        if (results_[own].state != CaseState::finished) return;
        std::string errors;
        for (std::size_t q = 0; q < study_.quantities.size(); ++q)
            if (const auto& error = evaluation_.errors[own][q])
                errors += (errors.empty() ? "" : ", ") + study_.quantities[q].name + " " + percent(*error);
        if (errors.empty()) return;
        sentences_.push_back(fmt::format("{}At {} a run takes {}; errors: {}.", prefix,
                                         study_.cases[own].label, time_text(results_[own].best_seconds()),
                                         errors));
    }

    [[nodiscard]] std::vector<Rung> ladder(const Design& design, std::size_t axis, std::size_t q) const {
        std::vector<Rung> rungs;
        std::vector<std::size_t> at = home(design);
        for (std::size_t v = 0; v < study_.axes[axis].values.size(); ++v) {
            at[axis] = v;
            const std::size_t place = case_at(study_, at);
            if (results_[place].state != CaseState::finished || !evaluation_.errors[place][q]) continue;
            rungs.push_back(
                {place, value_label(axis, v), *evaluation_.errors[place][q], results_[place].best_seconds()});
        }
        std::stable_sort(rungs.begin(), rungs.end(),
                         [](const Rung& a, const Rung& b) { return a.seconds < b.seconds; });
        return rungs;
    }

    /// The cheapest against the dearest of an axis, by the first quantity.
    void ends(const Design& design, std::size_t axis, const std::string& prefix) {
        const auto rungs = ladder(design, axis, 0);
        if (rungs.size() < 2 || !(rungs.front().seconds > 0)) return;
        const Rung &cheap = rungs.front(), &dear = rungs.back();
        const Reference& reference = design.references[0];
        const std::string to = reference.exact ? "the exact answer" : "the reference";
        const double times = dear.seconds / cheap.seconds;
        const bool alike = !reference.exact && std::abs(cheap.error - dear.error) <= reference.uncertainty;
        const std::string verdict =
            alike ? fmt::format(
                        "they differ by less than the reference is certain to (± {}), and {} is {:.1f} "
                        "times cheaper",
                        percent(reference.uncertainty), cheap.label, times)
            : cheap.error <= dear.error
                ? fmt::format("{} is nearer to {} and {:.1f} times cheaper", cheap.label, to, times)
                : fmt::format("{} is {:.1f} times nearer to {} and costs {:.1f} times as much", dear.label,
                              cheap.error / dear.error, to, times);
        sentences_.push_back(fmt::format("{}{}: {} has an error of {} and takes {}; {}: {}, {}. So {}{}.",
                                         prefix, study_.quantities[0].name, cheap.label, percent(cheap.error),
                                         time_text(cheap.seconds), dear.label, percent(dear.error),
                                         time_text(dear.seconds), verdict, elsewhere(home(design), axis)));
    }

    void methods(const Design& design, std::size_t axis, const std::string& prefix) {
        std::string list;
        std::vector<std::size_t> at = home(design);
        for (std::size_t v = 0; v < study_.axes[axis].values.size(); ++v) {
            at[axis] = v;
            const std::size_t place = case_at(study_, at);
            const CaseResult& result = results_[place];
            const auto& error = evaluation_.errors[place][0];
            list += (list.empty() ? "" : "; ") + study_.axes[axis].values[v].label + " ";
            if (result.state != CaseState::finished)
                list += state_name(result.state);
            else
                list += fmt::format("{}, {}", error ? percent(*error) : "is the reference",
                                    time_text(result.best_seconds()));
        }
        sentences_.push_back(fmt::format("{}{}, error and time by {}: {}{}.", prefix,
                                         study_.quantities[0].name, study_.axes[axis].axis.name, list,
                                         elsewhere(home(design), axis)));
    }

    const Study& study_;
    const std::vector<CaseResult>& results_;
    const Evaluation& evaluation_;
    std::vector<std::string> sentences_;
};

}  // namespace

std::vector<std::string> conclusions(const Study& study, const std::vector<CaseResult>& results,
                                     const Evaluation& evaluation) {
    if (study.quantities.empty()) return {};
    return Speaker(study, results, evaluation).speak();
}

}  // namespace percuss::app
