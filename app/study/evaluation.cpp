#include "study/evaluation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include <fmt/format.h>

#include "exit_status.hpp"
#include "figures/run_figure.hpp"
#include "nearest_name.hpp"
#include "run/force_error.hpp"
#include "run/history_columns.hpp"

namespace percuss::app {
namespace {

using Places = std::vector<std::size_t>;

bool finished(const CaseResult& result) { return result.state == CaseState::finished; }

std::vector<Design> designs_of(const Study& study) {
    std::map<Places, std::size_t> found;
    std::vector<Design> designs;
    for (std::size_t i = 0; i < study.cases.size(); ++i) {
        Places at;
        std::string label;
        for (std::size_t a = 0; a < study.axes.size(); ++a) {
            const Variation& axis = study.axes[a];
            if (axis.axis.kind != AxisKind::design) continue;
            at.push_back(study.cases[i].at[a]);
            if (axis.values.size() > 1) label += (label.empty() ? "" : ", ") + axis.describe(at.back());
        }
        const auto [place, fresh] = found.emplace(at, designs.size());
        if (fresh) designs.push_back({label, {}, {}, {}, {}});
        designs[place->second].cases.push_back(i);
    }
    return designs;
}

/// The finished cases of a design along the refined axis, finest first, all other axes where they are best:
/// methods at their own value, the step at its smallest.
Places finest_series(const Study& study, const std::vector<CaseResult>& results, const Design& design) {
    const auto refined = refined_axis(study);
    const auto step = axis_of_kind(study, AxisKind::step);
    const auto size = [&](std::size_t i, std::size_t axis) { return level_size(study, axis, results[i]); };
    Places best;
    double best_step = 0;
    std::map<Places, Places> series;  // by the places on the other axes
    for (const std::size_t i : design.cases) {
        if (!finished(results[i])) continue;
        Places others = study.cases[i].at;
        if (refined) others[*refined] = 0;
        series[others].push_back(i);
    }
    // By most methods at home, then by most levels, then by the smallest step.
    std::size_t best_home = 0;
    for (auto& [others, cases] : series) {
        std::size_t home = 0;
        for (std::size_t a = 0; a < study.axes.size(); ++a)
            home += study.axes[a].axis.kind == AxisKind::method && others[a] == study.axes[a].home();
        const double dt = step && step != refined ? size(cases.front(), *step) : 0;
        const bool better = best.empty() || home > best_home ||
                            (home == best_home &&
                             (cases.size() > best.size() || (cases.size() == best.size() && dt < best_step)));
        if (!better) continue;
        best = cases, best_home = home, best_step = dt;
    }
    if (refined)
        std::stable_sort(best.begin(), best.end(),
                         [&](std::size_t a, std::size_t b) { return size(a, *refined) < size(b, *refined); });
    return best;
}

class Judge {
  public:
    Judge(const Study& study, const std::vector<CaseResult>& results, Evaluation& evaluation)
        : study_(study), results_(results), evaluation_(evaluation) {}

    void judge(Design& design) {
        const Places series = finest_series(study_, results_, design);
        for (std::size_t q = 0; q < study_.quantities.size(); ++q) {
            design.references.push_back(is_history(study_.quantities[q], study_)
                                            ? judge_history(design, q, series)
                                            : judge_number(design, q, series));
            std::vector<Offer> offers;
            for (const std::size_t i : design.cases)
                offers.push_back({results_[i].best_seconds(), evaluation_.errors[i][q]});
            Places front = pareto_front(offers, 0.01);
            for (std::size_t& place : front) place = design.cases[place];
            design.fronts.push_back(std::move(front));
            const auto cheapest = cheapest_within(offers, study_.quantities[q].tolerance);
            design.cheapest.push_back(cheapest ? std::optional(design.cases[*cheapest]) : std::nullopt);
        }
    }

  private:
    Reference judge_history(const Design& design, std::size_t q, const Places& series) {
        const std::string& column = study_.quantities[q].of;
        Reference reference;
        if (const ExactHistory* exact = exact_of(*scene_of(design), column)) {
            for (const std::size_t i : design.cases)
                if (finished(results_[i]))
                    set_error(i, q, results_[i].number("exact." + column + ".error_averaged"));
            reference.exact = true;
            reference.how = exact->label;
            return reference;
        }
        if (series.empty()) return reference;
        const std::size_t finest = series.front();
        const Scene& scene = *study_.cases[finest].scene;
        const double window = scene.analysis.window.value_or(scene.duration / 200);
        for (const std::size_t i : design.cases) {
            if (!finished(results_[i]) || i == finest) continue;
            set_error(i, q, distance(i, finest, column, window, scene.duration));
        }
        reference.own = finest;
        reference.how = "the finest case, " + study_.cases[finest].label;
        reference.uncertainty = std::numeric_limits<double>::infinity();
        if (series.size() > 1)
            if (const auto error = evaluation_.errors[series[1]][q]) {
                reference.uncertainty = *error;
                reference.how += "; uncertain by its distance to the next coarser one";
            }
        return reference;
    }

    std::optional<double> distance(std::size_t i, std::size_t from, const std::string& column, double window,
                                   double duration) const {
        const auto &a = results_[i].histories, &b = results_[from].histories;
        try {
            return history_error(a.at("time"), a.at(column), b.at("time"), b.at(column), window, duration);
        } catch (const std::invalid_argument&) {
            return std::nullopt;  // a history of zeros
        }
    }

    Reference judge_number(const Design& design, std::size_t q, const Places& series) {
        const StudyQuantity& quantity = study_.quantities[q];
        for (const std::size_t i : design.cases)
            if (finished(results_[i])) evaluation_.values[i][q] = results_[i].number(quantity.of);
        Reference reference;
        double uncertainty = 0;
        if (quantity.exact) {
            // It may follow from parameters, which differ from design to design.
            const Scene& scene = *scene_of(design);
            reference.value = quantity.exact;
            if (scene.study)
                for (const StudyQuantity& own : scene.study->quantities)
                    if (own.of == quantity.of && own.exact) reference.value = own.exact;
            reference.exact = true;
            reference.how = "exact";
        } else {
            std::vector<Level> levels;
            for (const std::size_t i : series)
                if (const auto value = evaluation_.values[i][q])
                    levels.push_back(
                        {refined_axis(study_) ? level_size(study_, *refined_axis(study_), results_[i]) : 1.0,
                         *value});
            if (levels.empty()) return reference;
            const Limit limit = extrapolate(levels);
            reference.value = limit.value;
            uncertainty = limit.uncertainty;
            reference.how = limit.how;
            if (!limit.extrapolated) reference.own = series.front();
        }
        const double scale = quantity.scale.value_or(std::abs(*reference.value));
        if (!(scale > 0)) {
            reference.how += "; it is 0, so that no error is relative to it: name a scale";
            return reference;
        }
        reference.uncertainty = uncertainty / scale;
        for (const std::size_t i : design.cases)
            if (evaluation_.values[i][q] && reference.own != i)
                set_error(i, q, std::abs(*evaluation_.values[i][q] - *reference.value) / scale);
        return reference;
    }

    [[nodiscard]] const Scene* scene_of(const Design& design) const {
        for (const std::size_t i : design.cases)
            if (study_.cases[i].scene) return &*study_.cases[i].scene;
        return &study_.scene;
    }

    void set_error(std::size_t i, std::size_t q, std::optional<double> error) {
        if (error && std::isfinite(*error)) evaluation_.errors[i][q] = error;
    }

    const Study& study_;
    const std::vector<CaseResult>& results_;
    Evaluation& evaluation_;
};

/// With an exact answer the order is that of the errors of the two finest levels, else that of three values.
/// Errors along steps alone end at those of the mesh and have no order.
std::optional<double> order_of(const Study& study, const std::vector<CaseResult>& results,
                               const Evaluation& evaluation, const Reference& reference, const Places& series,
                               std::size_t axis, std::size_t q) {
    if (reference.exact && study.axes[axis].axis.kind == AxisKind::mesh) {
        if (series.size() < 2) return std::nullopt;
        const auto fine = evaluation.errors[series[0]][q], coarse = evaluation.errors[series[1]][q];
        const double h = level_size(study, axis, results[series[0]]),
                     coarser = level_size(study, axis, results[series[1]]);
        if (!fine || !coarse || !(*fine > 0) || !(*coarse > 0) || !(coarser > h)) return std::nullopt;
        return std::log(*coarse / *fine) / std::log(coarser / h);
    }
    std::vector<Level> levels;
    for (const std::size_t i : series)
        if (const auto value = evaluation.values[i][q])
            levels.push_back({level_size(study, axis, results[i]), *value});
    return observed_order(levels);
}

void find_orders(const Study& study, const std::vector<CaseResult>& results, Evaluation& evaluation) {
    for (std::size_t axis = 0; axis < study.axes.size(); ++axis) {
        const AxisKind kind = study.axes[axis].axis.kind;
        if (kind != AxisKind::mesh && kind != AxisKind::step) continue;
        for (const Design& design : evaluation.designs) {
            std::map<Places, Places> series;
            for (const std::size_t i : design.cases) {
                if (!finished(results[i])) continue;
                Places others = study.cases[i].at;
                others[axis] = 0;
                series[others].push_back(i);
            }
            for (auto& [others, cases] : series) {
                std::stable_sort(cases.begin(), cases.end(), [&](std::size_t a, std::size_t b) {
                    return level_size(study, axis, results[a]) < level_size(study, axis, results[b]);
                });
                for (std::size_t q = 0; q < study.quantities.size(); ++q)
                    if (const auto order =
                            order_of(study, results, evaluation, design.references[q], cases, axis, q))
                        evaluation.orders.push_back({axis, label_without(study, others, axis), q, *order});
            }
        }
    }
}

void collect_paths(const nlohmann::ordered_json& node, const std::string& path,
                   std::vector<std::string>& paths) {
    if (node.is_number()) paths.push_back(path);
    if (node.is_object())
        for (const auto& [key, value] : node.items())
            collect_paths(value, path.empty() ? key : path + "." + key, paths);
}

/// What a run has only when it happens.
bool may_be_missing(const std::string& path) {
    for (const char* part : {".stops.", ".first_touch", ".last_touch"})
        if (path.find(part) != std::string::npos) return true;
    return false;
}

}  // namespace

std::string label_without(const Study& study, const Places& at, std::size_t left_out) {
    std::string label;
    for (std::size_t a = 0; a < study.axes.size(); ++a) {
        if (a == left_out || study.axes[a].values.size() < 2) continue;
        label += (label.empty() ? "" : ", ") + study.axes[a].describe(at[a]);
    }
    return label;
}

std::optional<std::size_t> axis_of_kind(const Study& study, AxisKind kind) {
    for (std::size_t a = 0; a < study.axes.size(); ++a)
        if (study.axes[a].axis.kind == kind && study.axes[a].values.size() > 1) return a;
    return std::nullopt;
}

std::optional<std::size_t> refined_axis(const Study& study) {
    const auto mesh = axis_of_kind(study, AxisKind::mesh);
    return mesh ? mesh : axis_of_kind(study, AxisKind::step);
}

std::size_t case_at(const Study& study, const std::vector<std::size_t>& at) {
    std::size_t place = 0;
    for (std::size_t a = 0; a < study.axes.size(); ++a) place = place * study.axes[a].values.size() + at[a];
    return place;
}

double level_size(const Study& study, std::size_t axis, const CaseResult& result) {
    const bool mesh = study.axes[axis].axis.kind == AxisKind::mesh;
    const double count = result.number(mesh ? "elements" : "steps").value_or(0);
    if (!(count > 0)) return 0;
    return mesh ? 1 / std::sqrt(count) : 1 / count;
}

void check_summary_keys(const Study& study, const CaseResult& result) {
    std::vector<std::string> paths;
    for (const StudyQuantity& quantity : study.quantities) {
        if (is_history(quantity, study) || result.number(quantity.of) || may_be_missing(quantity.of))
            continue;
        if (paths.empty()) {
            collect_paths(result.summary, "", paths);
            for (const HistoryColumn& column : history_columns(study.scene)) paths.push_back(column.name);
        }
        std::string nearest = nearest_name(quantity.of, paths);
        throw UsageError(
            fmt::format("quantity '{}' is neither a history column of the scene nor a number of "
                        "summary.json; the nearest is '{}'",
                        quantity.of, nearest));
    }
}

Evaluation evaluate(const Study& study, const std::vector<CaseResult>& results) {
    Evaluation evaluation;
    const std::vector<std::optional<double>> none(study.quantities.size());
    evaluation.values.assign(study.cases.size(), none);
    evaluation.errors = evaluation.values;
    evaluation.designs = designs_of(study);
    for (const CaseResult& result : results)
        if (finished(result)) {
            check_summary_keys(study, result);
            break;
        }
    Judge judge(study, results, evaluation);
    for (Design& design : evaluation.designs) judge.judge(design);
    find_orders(study, results, evaluation);
    return evaluation;
}

}  // namespace percuss::app
