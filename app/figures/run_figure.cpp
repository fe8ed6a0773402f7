#include "figures/run_figure.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "exit_status.hpp"
#include "record/run_file.hpp"
#include "record/summary.hpp"
#include "report.hpp"
#include "scene/parse.hpp"

namespace percuss::app {

const ExactHistory* exact_of(const Scene& scene, const std::string& column) {
    const auto found = std::find_if(scene.exact.begin(), scene.exact.end(),
                                    [&](const ExactHistory& exact) { return exact.quantity == column; });
    return found == scene.exact.end() ? nullptr : &*found;
}

namespace {

std::size_t column_index(const RecordedRun& run, const std::string& column) {
    try {
        return run.history->column(column);
    } catch (const std::invalid_argument& error) {
        throw UsageError(fmt::format("--column: {}", error.what()));
    }
}

/// One history column of all runs, in the units that its largest value and the longest run call for.
class ColumnCharts {
  public:
    ColumnCharts(const std::vector<RecordedRun>& runs, std::string column, bool with_exact)
        : column_(std::move(column)), with_exact_(with_exact) {
        double end = 0;
        for (const RecordedRun& run : runs) {
            end = std::max(end, run.setup->scene.duration);
            for (const double value : run.history->values(column_index(run, column_), 0, run.history->rows()))
                include(value);
            const ExactHistory* exact = with_exact_ ? exact_of(run.setup->scene, column_) : nullptr;
            if (exact == nullptr) continue;
            for (const auto& [time, value] : exact->points) include(value);
        }
        const RecordedRun& first = runs.front();
        const Quantity quantity = first.history->columns()[column_index(first, column_)].quantity;
        const Units& units = first.setup->scene.units;
        unit_ = units.display(quantity, std::max(std::abs(low_), std::abs(high_)));
        time_unit_ = units.display(Quantity::time, end);
        end_ = end * time_unit_.scale;
    }

    [[nodiscard]] render::Chart chart(const std::string& title) const {
        render::Chart chart;
        chart.title = title;
        chart.x_title = fmt::format("time [{}]", time_unit_.label);
        chart.y_title =
            column_title(column_) + (unit_.label.empty() ? "" : fmt::format(" [{}]", unit_.label));
        chart.x_range = {0, end_};
        const double margin = 0.05 * (high_ - low_);
        if (margin > 0) chart.y_range = {unit_.scale * (low_ - margin), unit_.scale * (high_ + margin)};
        return chart;
    }

    [[nodiscard]] render::Curve computed(const RecordedRun& run, const std::string& label) const {
        render::Curve curve{label, run.history->values("time"), run.history->values(column_), false};
        const std::size_t rows = std::min(curve.x.size(), curve.y.size());
        curve.x.resize(rows);
        curve.y.resize(rows);
        for (double& time : curve.x) time *= time_unit_.scale;
        for (double& value : curve.y) value *= unit_.scale;
        return curve;
    }

    void add_exact(const RecordedRun& run, render::Chart& chart) const {
        const ExactHistory* exact = with_exact_ ? exact_of(run.setup->scene, column_) : nullptr;
        if (exact == nullptr) return;
        render::Curve curve{exact->label, {}, {}, true};
        const auto add = [&](double time, double value) {
            curve.x.push_back(time * time_unit_.scale);
            curve.y.push_back(value * unit_.scale);
        };
        // The answer is 0 outside its points; draw that too, so that a pulse is seen to begin and to end.
        const auto &first = exact->points.front(), &last = exact->points.back();
        if (first.first >= 0) add(0, 0), add(first.first, 0);
        for (const auto& [time, value] : exact->points) add(time, value);
        const double end = run.setup->scene.duration;
        if (last.first < end) add(last.first, 0), add(end, 0);
        chart.curves.push_back(std::move(curve));
    }

  private:
    void include(double value) {
        if (!std::isfinite(value)) return;
        low_ = std::min(low_, value);
        high_ = std::max(high_, value);
    }

    std::string column_;
    bool with_exact_;
    double low_ = 0, high_ = 0, end_ = 0;
    DisplayUnit unit_, time_unit_;
};

/// "Δt = 200 ns; error 7.7 %, averaged over 0.8 µs 5.4 %" where the run's summary knows the errors.
std::string chart_title(const RecordedRun& run, const std::string& column) {
    const auto value = [&](const char* key) {
        return summary_value(run.summary, fmt::format("exact.{}.{}", column, key));
    };
    const auto error = value("error"), averaged = value("error_averaged"), window = value("window");
    if (!error || !averaged || !window) return run.label;
    return fmt::format("{}; error {:.1f} %, averaged over {} {:.1f} %", run.label, 100 * *error,
                       with_unit(run.setup->scene.units, Quantity::time, *window), 100 * *averaged);
}

}  // namespace

RecordedRun load_recorded_run(const std::filesystem::path& run_file,
                              const std::vector<std::string>& overrides) {
    auto file = std::make_shared<const RunFile>(run_file);
    auto setup = file->setup();
    if (!overrides.empty()) {
        auto changed = std::make_shared<RunSetup>(*setup);
        std::vector<std::string> all = setup->scene.overrides;
        all.insert(all.end(), overrides.begin(), overrides.end());
        changed->scene = parse_scene(setup->scene.text, setup->scene.file, all);
        setup = std::move(changed);
    }
    RunFrames frames{file->frame_times(),
                     [file](std::size_t index) { return file->frame(static_cast<std::int64_t>(index)); }};
    RecordedRun run{step_label(setup->scene), setup, file->history(), {}, std::move(frames), file->traces()};
    const std::string summary = file->summary();
    if (!summary.empty()) run.summary = nlohmann::ordered_json::parse(summary);
    return run;
}

const Trace& trace_of(const RecordedRun& run, const std::string& figure) {
    for (const Trace& trace : run.traces) {
        if (trace.name != figure) continue;
        if (trace.rows->rows() == 0)
            throw UsageError(fmt::format("figure '{}': the run recorded no row for it", figure));
        return trace;
    }
    throw UsageError(fmt::format("figure '{}' needs what a run records for it; run the scene again", figure));
}

std::string step_label(const Scene& scene) {
    const std::string lagged = scene.lagged ? ", lagged" : "";
    if (scene.step.fixed) return "Δt = " + with_unit(scene.units, Quantity::time, *scene.step.fixed) + lagged;
    return fmt::format("Δt = {:.3g} of critical{}", scene.step.courant, lagged);
}

std::string column_title(const std::string& column) {
    const std::size_t first = column.find('.'), last = column.rfind('.');
    if (first == std::string::npos) return column;
    const std::string kind = column.substr(0, first), leaf = column.substr(last + 1);
    if (column == "energy.balance") return "energy balance E - I - K";
    if (kind == "energy") return leaf + " energy";
    if (first == last) return column;
    const std::string name = column.substr(first + 1, column.find('.', first + 1) - first - 1);
    const std::string rest = column.substr(first + 1 + name.size() + 1);
    const bool direction = leaf == "axial" || leaf == "radial" || leaf == "x" || leaf == "y";
    if (kind == "contact" && rest == leaf && direction)
        return fmt::format("contact force of {}, {}", name, leaf);
    if (kind == "contact" && rest.starts_with("friction."))
        return fmt::format("friction of {}, {}", name, leaf);
    if (kind == "body" && rest.starts_with("velocity.")) return fmt::format("{} velocity of {}", leaf, name);
    if (kind == "body" && rest.starts_with("drive."))
        return fmt::format("{} force that drives {}", leaf, name);
    if (kind == "probe" && rest.starts_with("stress.")) return fmt::format("{} stress at {}", leaf, name);
    return column;
}

render::Figure make_figure(const std::vector<RecordedRun>& runs, const FigureLayout& layout) {
    std::vector<ColumnCharts> columns;
    for (const std::string& column : layout.columns) columns.emplace_back(runs, column, layout.exact);
    render::Figure figure;
    if (layout.together) {
        for (std::size_t c = 0; c < columns.size(); ++c) {
            render::Chart chart = columns[c].chart(column_title(layout.columns[c]));
            for (const RecordedRun& run : runs) chart.curves.push_back(columns[c].computed(run, run.label));
            columns[c].add_exact(runs.front(), chart);
            figure.charts.push_back(std::move(chart));
        }
        return figure;
    }
    figure.columns = static_cast<int>(columns.size());
    for (const RecordedRun& run : runs) {
        for (std::size_t c = 0; c < columns.size(); ++c) {
            render::Chart chart = columns[c].chart(chart_title(run, layout.columns[c]));
            chart.curves.push_back(columns[c].computed(run, "computed"));
            columns[c].add_exact(run, chart);
            figure.charts.push_back(std::move(chart));
        }
    }
    return figure;
}

}  // namespace percuss::app
