#include "workbench/export/plot_files.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

#include <fmt/format.h>

#include "figures/ticks.hpp"
#include "output.hpp"
#include "record/csv_cell.hpp"
#include "workbench/shown_curves.hpp"

namespace percuss::app {
namespace {

PlotRun rows_within(const Curves& curves, std::shared_ptr<const History> history,
                    const std::array<double, 2>& times) {
    const std::size_t begin = curves.row_at(times[0]);
    std::size_t end = curves.row_at(times[1]);
    if (end < curves.rows() && curves.times()[end] <= times[1]) ++end;
    return {std::move(history), "", begin, std::max(begin, end), {}, {}};
}

/// Rows before this time are thinned; those that are not shown do not count.
void note_thinned(PlotContents& contents, double before) {
    if (before <= contents.times[0]) return;
    contents.thinned_before = std::max(contents.thinned_before.value_or(before), before);
}

void note_thinned(PlotContents& contents, const Curves& curves) {
    const std::size_t thinned = curves.times().thinned();
    if (thinned > 0 && thinned < curves.rows()) note_thinned(contents, curves.times()[thinned]);
}

/// When the thinned rows of a run end; absent: none of them is shown.
std::optional<double> end_of_thinned(const PlotRun& run) {
    const std::size_t thinned = run.history->thinned_rows();
    if (thinned <= run.begin || thinned >= run.history->rows()) return std::nullopt;
    return run.history->values(0, thinned, thinned + 1).front();
}

constexpr int points_of_a_drawn_rate = 1000;

/// A curve that the run's history does not have.
PlotRun run_of_points(const std::vector<CurvePoint>& points, const std::string& name, Quantity quantity,
                      std::size_t place, const std::array<double, 2>& times) {
    auto history =
        std::make_shared<History>(std::vector<HistoryColumn>{{"time", Quantity::time}, {name, quantity}});
    for (const CurvePoint& point : points) {
        if (point.time < times[0] || point.time > times[1]) continue;
        history->append(std::array{point.time, point.value});
    }
    const std::size_t rows = history->rows();
    return {std::move(history), "", 0, rows, {1}, {place}};
}

/// The rows of a run, one after the other. Where its history is thinned there is one for the least and one
/// for the greatest of a group of steps, and a last column says so.
class RowWriter {
  public:
    explicit RowWriter(const PlotRun& run) : run_(&run), row_(run.begin) {}
    [[nodiscard]] bool left() const { return row_ < run_->end; }
    [[nodiscard]] bool says_kind() const { return run_->begin < run_->history->thinned_rows(); }
    void write(fmt::memory_buffer& text) {
        if (!left()) {  // another run has more rows
            for (std::size_t k = 0; k < run_->columns.size() + (says_kind() ? 1 : 0); ++k)
                text.push_back(',');
            return;
        }
        const std::vector<double> values = run_->history->table(row_, row_ + 1);
        fmt::format_to(std::back_inserter(text), "{:.17g}", values[0]);
        for (const std::size_t column : run_->columns)
            fmt::format_to(std::back_inserter(text), ",{:.17g}", values[column]);
        const std::size_t grain = run_->history->grain(row_), half = std::max<std::size_t>(grain / 2, 1);
        if (says_kind())
            fmt::format_to(std::back_inserter(text), ",{}",
                           grain == 1 ? "step"
                                      : fmt::format("{} of {} steps",
                                                    row_ % grain < half ? "least" : "greatest", grain));
        row_ = (row_ / half + 1) * half;
    }

  private:
    const PlotRun* run_;
    std::size_t row_;
};

std::string heading(const Units& units, const HistoryColumn& column, const std::string& prefix) {
    const std::string label = units.label(column.quantity);
    return csv_cell(prefix + (label.empty() ? column.name : fmt::format("{} [{}]", column.name, label)));
}

}  // namespace

PlotContents contents_of(Workbench& w, const PlotInfo& plot) {
    const Scene& scene = w.run.snapshot()->setup->scene;
    PlotContents contents{plot, scene.units, scene.duration, shown_times(w), {}};
    PlotRun present = rows_within(w.plots.curves, w.run.history(), contents.times), reference;
    if (w.reference) reference = rows_within(w.reference->curves, w.reference->history, contents.times);
    reference.prefix = "reference ";
    std::vector<PlotRun> others;
    for (std::size_t i = 0; i < plot.curves.size(); ++i) {
        const CurveInfo& curve = plot.curves[i];
        if (!shown(w.plots, plot, curve)) continue;
        if (curve.own) {  // a probe of the window has rows of its own
            const MinMaxPyramid& values = curve.own->column(curve.column);
            std::vector<CurvePoint> points;
            const std::size_t thinned = values.thinned();
            for (std::size_t row = 0; row < curve.own->rows(); ++row) {
                const double time = curve.own->times()[row];
                const MinMax known =
                    row < thinned ? values.range(row, row + 1) : MinMax{values[row], values[row]};
                // Once for a group of steps that are known together.
                const bool again = row < thinned && points.size() > 1 && points.back().value == known.high &&
                                   points[points.size() - 2].value == known.low;
                if (again) continue;
                points.push_back({time, known.low});
                if (row < thinned) points.push_back({time, known.high});
            }
            std::string name = "probe." + curve.label;
            if (thinned > 0)
                name += fmt::format(", before {:.6g} least and greatest of some steps",
                                    curve.own->times()[thinned]);
            others.push_back(run_of_points(points, name, plot.quantity, i, contents.times));
            note_thinned(contents, *curve.own);
            continue;
        }
        present.columns.push_back(curve.column);
        present.places.push_back(i);
        const auto column = reference_column(w, curve);
        if (!column) continue;
        reference.columns.push_back(*column);
        reference.places.push_back(i);
    }
    if (!present.columns.empty()) contents.runs.push_back(std::move(present));
    for (PlotRun& run : others) contents.runs.push_back(std::move(run));
    if (!reference.columns.empty()) contents.runs.push_back(std::move(reference));
    return contents;
}

PlotContents drawn_contents_of(Workbench& w, const PlotInfo& plot) {
    if (!plot.rate) return contents_of(w, plot);
    const Scene& scene = w.run.snapshot()->setup->scene;
    PlotContents contents{plot, scene.units, scene.duration, shown_times(w), {}};
    const auto add = [&](Curves& curves, std::size_t column, std::size_t place, const char* prefix) {
        std::vector<CurvePoint> points;
        rates(curves, curves.column(column), contents.times[0], contents.times[1], points_of_a_drawn_rate,
              rate_window(w), points);
        contents.runs.push_back(
            run_of_points(points, plot.curves[place].label, plot.quantity, place, contents.times));
        contents.runs.back().prefix = prefix;
        note_thinned(contents, curves);
    };
    for (std::size_t i = 0; i < plot.curves.size(); ++i)
        if (shown(w.plots, plot, plot.curves[i])) add(w.plots.curves, plot.curves[i].column, i, "");
    for (std::size_t i = 0; i < plot.curves.size(); ++i)
        if (const auto column = reference_column(w, plot.curves[i]);
            column && shown(w.plots, plot, plot.curves[i]))
            add(w.reference->curves, *column, i, "reference ");
    return contents;
}

void write_plot_csv(const std::filesystem::path& file, const PlotContents& contents) {
    write_whole(file, [&](const std::filesystem::path& aside) {
        std::ofstream out(aside, std::ios::binary);
        fmt::memory_buffer text;
        const char* comma = "";
        std::vector<RowWriter> writers;
        for (const PlotRun& run : contents.runs) {
            writers.emplace_back(run);
            const auto& columns = run.history->columns();
            const auto head = [&](const std::string& words) {
                fmt::format_to(std::back_inserter(text), "{}{}", comma, words);
                comma = ",";
            };
            head(heading(contents.units, columns[0], run.prefix));
            for (const std::size_t column : run.columns)
                head(heading(contents.units, columns[column], run.prefix));
            if (writers.back().says_kind()) head(csv_cell(run.prefix + "what the row is"));
        }
        text.push_back('\n');
        const auto some_left = [&] {
            return std::any_of(writers.begin(), writers.end(), [](const RowWriter& w) { return w.left(); });
        };
        while (some_left()) {
            for (std::size_t k = 0; k < writers.size(); ++k) {
                if (k > 0) text.push_back(',');
                writers[k].write(text);
            }
            text.push_back('\n');
            if (text.size() > 1 << 20) {
                out.write(text.data(), static_cast<std::streamsize>(text.size()));
                text.clear();
            }
        }
        out.write(text.data(), static_cast<std::streamsize>(text.size()));
        out.close();
        if (!out) throw std::runtime_error(fmt::format("{}: cannot be written", file.string()));
    });
}

namespace {

std::optional<double> thinned_before(const PlotContents& contents) {
    std::optional<double> before = contents.thinned_before;
    for (const PlotRun& run : contents.runs)
        if (const auto end = end_of_thinned(run)) before = std::max(before.value_or(*end), *end);
    return before;
}

}  // namespace

render::Figure figure_of(const PlotContents& contents, const std::string& title) {
    const DisplayUnit time = contents.units.display(Quantity::time, contents.duration);
    std::vector<render::Curve> curves;
    double largest = 0;
    bool dashed = false;
    for (const PlotRun& run : contents.runs) {
        std::vector<double> times = run.history->values(0, run.begin, run.end);
        for (double& t : times) t *= time.scale;
        for (std::size_t k = 0; k < run.columns.size(); ++k) {
            render::Curve curve;
            const bool reference = !run.prefix.empty();
            if (!reference) curve.label = contents.plot.curves[run.places[k]].label;
            curve.x = times;
            curve.y = run.history->values(run.columns[k], run.begin, run.end);
            curve.dashed = reference;
            dashed = dashed || reference;
            curve.colour = run.places[k];
            for (const double value : curve.y)
                if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
            curves.push_back(std::move(curve));
        }
    }
    const DisplayUnit unit = contents.plot.rate ? DisplayUnit{1 / time.scale, "1/" + time.label}
                                                : contents.units.display(contents.plot.quantity, largest);
    for (render::Curve& curve : curves)
        for (double& value : curve.y) value *= unit.scale;
    render::Chart chart;
    const auto titled = [](const std::string& name, const DisplayUnit& of) {
        return of.label.empty() ? name : fmt::format("{} [{}]", name, of.label);
    };
    if (dashed) chart.title = "dashed: the reference";
    if (const auto before = thinned_before(contents))
        chart.title += fmt::format("{}until {}{}{} the least and greatest of every few steps",
                                   dashed ? "; " : "", render::format_number(time.scale * *before, 4),
                                   time.label.empty() ? "" : " ", time.label);
    chart.x_title = titled("time", time);
    chart.y_title = titled(contents.plot.title, unit);
    chart.x_range = {time.scale * contents.times[0], time.scale * contents.times[1]};
    chart.curves = std::move(curves);
    render::Figure figure;
    figure.title = title;
    figure.charts.push_back(std::move(chart));
    return figure;
}

}  // namespace percuss::app
