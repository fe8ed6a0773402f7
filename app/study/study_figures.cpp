#include "study/study_figures.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "figures/run_figure.hpp"
#include "run/history_columns.hpp"
#include "study/study_table.hpp"

namespace percuss::app {
namespace {

using Places = std::vector<std::size_t>;

/// One design's pictures.
class Painter {
  public:
    Painter(const Study& study, const std::vector<CaseResult>& results, const Evaluation& evaluation,
            const Design& design)
        : study_(study), results_(results), evaluation_(evaluation), design_(design) {}

    [[nodiscard]] render::Page cost() const {
        std::vector<render::Panel> panels;
        for (std::size_t q = 0; q < study_.quantities.size(); ++q) {
            render::Scatter scatter = scatter_of(q, axis_of_kind(study_, AxisKind::step),
                                                 [&](std::size_t i) { return results_[i].best_seconds(); });
            if (scatter.series.empty()) continue;
            scatter.x_title = "time of stepping [s]";
            for (const std::size_t i : design_.fronts[q]) {
                scatter.front_x.push_back(results_[i].best_seconds());
                scatter.front_y.push_back(100 * *evaluation_.errors[i][q]);
                scatter.notes.push_back({scatter.front_x.back(), scatter.front_y.back(), short_label(i)});
            }
            scatter.limit = 100 * study_.quantities[q].tolerance;
            scatter.limit_label = percent(study_.quantities[q].tolerance);
            panels.emplace_back(std::move(scatter));
        }
        return sheet("Error against time", std::move(panels), 620);
    }

    [[nodiscard]] render::Page convergence() const {
        std::vector<render::Panel> panels;
        const auto axis = refined_axis(study_);
        for (std::size_t q = 0; axis && q < study_.quantities.size(); ++q) {
            render::Scatter scatter = scatter_of(
                q, axis, [&](std::size_t i) { return size_of(i, *axis); }, true);
            const bool curves = std::any_of(scatter.series.begin(), scatter.series.end(),
                                            [](const auto& s) { return s.x.size() > 1; });
            if (!curves) continue;
            const Variation& refined = study_.axes[*axis];
            scatter.x_title = refined.axis.name + (refined.unit.empty() ? "" : " [" + refined.unit + "]");
            panels.emplace_back(std::move(scatter));
        }
        return sheet("Convergence", std::move(panels), 560);
    }

    [[nodiscard]] render::Page histories() const {
        std::vector<render::Panel> panels;
        for (const StudyQuantity& quantity : study_.quantities) {
            if (!is_history(quantity, study_)) continue;
            for (std::size_t a = 0; a < study_.axes.size(); ++a) {
                if (study_.axes[a].values.size() < 2 || study_.axes[a].axis.kind == AxisKind::design)
                    continue;
                render::Chart chart = history_chart(quantity, a);
                if (!chart.curves.empty()) panels.emplace_back(std::move(chart));
            }
        }
        return sheet("Histories", std::move(panels), 520);
    }

  private:
    /// Panels two abreast, or one.
    [[nodiscard]] render::Page sheet(const std::string& title, std::vector<render::Panel> panels,
                                     double panel_height) const {
        render::Page page;
        page.title = design_.label.empty() ? title : title + ", " + design_.label;
        const std::size_t across = panels.size() > 1 ? 2 : 1, down = (panels.size() + across - 1) / across;
        page.width = across > 1 ? 1900 : 1200;
        page.type = 1.3;
        page.height = static_cast<int>(panel_height * static_cast<double>(down)) + 80;
        const double wide = 1.0 / static_cast<double>(across),
                     high = 1.0 / static_cast<double>(std::max<std::size_t>(down, 1));
        for (std::size_t p = 0; p < panels.size(); ++p)
            page.panels.push_back({std::move(panels[p]),
                                   {static_cast<double>(p % across) * wide,
                                    static_cast<double>(p / across) * high, wide, high}});
        return page;
    }

    [[nodiscard]] std::string value_label(std::size_t axis, std::size_t i) const {
        return study_.axes[axis].describe(study_.cases[i].at[axis]);
    }

    /// What tells a point of one colour from the others.
    [[nodiscard]] std::string short_label(std::size_t i) const {
        std::string label;
        for (std::size_t a = 0; a < study_.axes.size(); ++a)
            if (study_.axes[a].values.size() > 1 && study_.axes[a].axis.kind != AxisKind::design &&
                study_.axes[a].axis.kind != AxisKind::method)
                label += (label.empty() ? "" : ", ") + value_label(a, i);
        return label.empty() ? study_.cases[i].label : label;
    }

    /// Colours tell methods; of a single one, the values of the other axis than the joined one.
    [[nodiscard]] std::string colour_label(std::size_t i, std::optional<std::size_t> joined) const {
        std::string label;
        for (const bool of_methods : {true, false}) {
            for (std::size_t a = 0; a < study_.axes.size(); ++a)
                if (study_.axes[a].values.size() > 1 && a != joined &&
                    study_.axes[a].axis.kind != AxisKind::design &&
                    (study_.axes[a].axis.kind == AxisKind::method) == of_methods)
                    label += (label.empty() ? "" : ", ") + value_label(a, i);
            if (!label.empty()) break;
        }
        return label;
    }

    /// The value of a refined axis as it was given when it is a number, else the size that the elements tell.
    [[nodiscard]] double size_of(std::size_t i, std::size_t axis) const {
        const std::string& text = study_.axes[axis].values[study_.cases[i].at[axis]].label;
        double value = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (error == std::errc() && end == text.data() + text.size()) return value;
        return level_size(study_, axis, results_[i]);
    }

    /// How many settings of a case are not the scene's own, the `left_out` axis and designs aside.
    [[nodiscard]] std::size_t off_home(std::size_t i, std::optional<std::size_t> left_out) const {
        std::size_t count = 0;
        for (std::size_t a = 0; a < study_.axes.size(); ++a)
            count += a != left_out && study_.axes[a].axis.kind != AxisKind::design &&
                     study_.cases[i].at[a] != study_.axes[a].home();
        return count;
    }

    /// Errors of one quantity; cases that differ by the `joined` axis alone are joined.
    /// @param few only the scene's own settings and those that differ from them by one; each line then has a
    /// colour and a name of its own, else colours tell methods.
    template <class Of>
    [[nodiscard]] render::Scatter scatter_of(std::size_t q, std::optional<std::size_t> joined, Of x_of,
                                             bool few = false) const {
        render::Scatter scatter;
        scatter.title = study_.quantities[q].name;
        scatter.y_title = "error [%]";
        std::map<Places, std::vector<std::size_t>> lines;
        for (const std::size_t i : design_.cases) {
            if (!evaluation_.errors[i][q] || (few && off_home(i, joined) > 1)) continue;
            Places others = study_.cases[i].at;
            if (joined) others[*joined] = 0;
            lines[others].push_back(i);
        }
        std::map<std::string, std::size_t> colours;
        for (auto& [others, cases] : lines) {
            std::stable_sort(cases.begin(), cases.end(),
                             [&](std::size_t a, std::size_t b) { return x_of(a) < x_of(b); });
            const std::string label =
                few ? label_without(study_, others, *joined) : colour_label(cases.front(), joined);
            const auto [colour, fresh] = colours.emplace(label, colours.size());
            render::Scatter::Series series;
            series.label = fresh ? label : "";
            series.colour = colour->second;
            series.joined = true;
            for (const std::size_t i : cases) {
                series.x.push_back(x_of(i));
                series.y.push_back(100 * *evaluation_.errors[i][q]);
            }
            scatter.series.push_back(std::move(series));
        }
        return scatter;
    }

    [[nodiscard]] render::Chart history_chart(const StudyQuantity& quantity, std::size_t axis) const {
        render::Chart chart;
        Places at = study_.cases[design_.cases.front()].at;
        std::string others;
        for (std::size_t a = 0; a < study_.axes.size(); ++a) {
            if (study_.axes[a].axis.kind != AxisKind::design) at[a] = study_.axes[a].home();
            if (a == axis || study_.axes[a].values.size() < 2 || study_.axes[a].axis.kind == AxisKind::design)
                continue;
            others += (others.empty() ? "" : ", ") + value_label(a, case_at(study_, at));
        }
        const Scene& scene = study_.scene;
        Quantity kind = Quantity::dimensionless;
        for (const HistoryColumn& column : history_columns(scene))
            if (column.name == quantity.of) kind = column.quantity;
        double largest = 0;
        std::vector<std::size_t> shown;
        for (std::size_t v = 0; v < study_.axes[axis].values.size(); ++v) {
            at[axis] = v;
            const std::size_t i = case_at(study_, at);
            const auto found = results_[i].histories.find(quantity.of);
            if (results_[i].state != CaseState::finished || found == results_[i].histories.end()) continue;
            shown.push_back(i);
            for (const double value : found->second) largest = std::max(largest, std::abs(value));
        }
        const DisplayUnit unit = scene.units.display(kind, largest),
                          time = scene.units.display(Quantity::time, scene.duration);
        const auto scaled = [](std::vector<double> values, double by) {
            for (double& value : values) value *= by;
            return values;
        };
        for (std::size_t k = 0; k < shown.size(); ++k) {
            const auto& histories = results_[shown[k]].histories;
            render::Curve curve;
            curve.label = value_label(axis, shown[k]);
            curve.x = scaled(histories.at("time"), time.scale);
            curve.y = scaled(histories.at(quantity.of), unit.scale);
            curve.dashed = k % 2 == 1;
            chart.curves.push_back(std::move(curve));
        }
        if (chart.curves.empty()) return chart;
        if (const ExactHistory* exact = exact_of(scene, quantity.of)) {
            render::Curve curve;
            curve.label = exact->label;
            curve.exact = true;
            for (const auto& [t, value] : exact->points) {
                curve.x.push_back(t * time.scale);
                curve.y.push_back(value * unit.scale);
            }
            chart.curves.push_back(std::move(curve));
        }
        chart.title =
            quantity.name + " by " + study_.axes[axis].axis.name + (others.empty() ? "" : "; " + others);
        chart.x_title = fmt::format("time [{}]", time.label);
        chart.y_title = quantity.name + (unit.label.empty() ? "" : fmt::format(" [{}]", unit.label));
        return chart;
    }

    const Study& study_;
    const std::vector<CaseResult>& results_;
    const Evaluation& evaluation_;
    const Design& design_;
};

/// "friction 0.1" -> "friction-0.1"
std::string file_part(const std::string& label) {
    std::string part;
    for (const char c : label) {
        const bool plain =
            (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.';
        if (plain)
            part += c;
        else if (!part.empty() && part.back() != '-')
            part += '-';
    }
    return part;
}

}  // namespace

std::vector<StudyFigure> study_figures(const Study& study, const std::vector<CaseResult>& results,
                                       const Evaluation& evaluation) {
    std::vector<StudyFigure> figures;
    for (const Design& design : evaluation.designs) {
        const Painter painter(study, results, evaluation, design);
        const std::string end = design.label.empty() ? "" : "-" + file_part(design.label);
        const auto add = [&](const char* name, std::string caption, render::Page page) {
            if (!page.panels.empty()) figures.push_back({name + end, std::move(caption), std::move(page)});
        };
        add("cost",
            "Each point is a case. Nothing lies below and left of the grey steps, the Pareto front, whose "
            "cases "
            "are named; the dashed line is the tolerance.",
            painter.cost());
        add("convergence", "Each line is of one setting; the others are the scene's own.",
            painter.convergence());
        add("histories", "One setting varies in each chart, the others are the scene's own.",
            painter.histories());
    }
    return figures;
}

}  // namespace percuss::app
