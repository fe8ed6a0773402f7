#include "figures/scheme_page.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace percuss::app {
namespace {

/// Cases in the charts of one column of the page, by their places in the list of all.
struct Group {
    std::string title;
    std::vector<std::size_t> cases;
};

/// A chart for each variant when there are several schemes to tell apart, else one for all.
std::vector<Group> groups_of(const std::vector<CaseRun>& cases) {
    const bool one_scheme = std::all_of(cases.begin(), cases.end(),
                                        [&](const CaseRun& c) { return c.scheme == cases.front().scheme; });
    std::vector<Group> groups;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const std::string title = one_scheme ? "" : cases[i].variant;
        if (groups.empty() || groups.back().title != title) groups.push_back({title, {}});
        groups.back().cases.push_back(i);
    }
    return groups;
}

/// What is drawn: the force, the judged history if that is another one, the energy.
std::vector<std::string> columns_of(const std::vector<CaseRun>& cases) {
    std::vector<std::string> columns{force_column(cases)};
    if (const std::string judged = judged_column(cases); judged != columns[0]) columns.push_back(judged);
    columns.emplace_back("energy.balance");
    return columns;
}

/// The ledger's E - I - K falls when energy comes from nowhere: turned over, losses go down.
void turn_over(render::Chart& chart) {
    for (render::Curve& curve : chart.curves)
        for (double& value : curve.y) value = -value;
    const std::size_t unit = chart.y_title.find(" [");
    chart.y_title = "energy change K + I - E" + (unit == std::string::npos ? "" : chart.y_title.substr(unit));
    chart.title = "energy: lost below 0, from nowhere above";
}

/// Of the runs that came to their end: what diverged would leave no room for the others.
std::optional<std::array<double, 2>> sound_range(const render::Chart& chart,
                                                 const std::vector<CaseRun>& cases) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    const bool none = std::all_of(cases.begin(), cases.end(), [](const CaseRun& c) { return c.diverged; });
    for (std::size_t k = 0; k < chart.curves.size(); ++k) {
        if (k < cases.size() && cases[k].diverged && !none) continue;
        for (const double value : chart.curves[k].y) {
            if (!std::isfinite(value)) continue;
            low = std::min(low, value);
            high = std::max(high, value);
        }
    }
    // What varies by rounding only is a flat line.
    const double largest = std::max(std::abs(low), std::abs(high));
    const double margin = high - low > 1e-9 * largest ? 0.05 * (high - low) : 0.1 * largest;
    return margin > 0 ? std::optional(std::array{low - margin, high + margin}) : std::nullopt;
}

/// The part of a chart of all cases that is of one group.
render::Chart chart_of(const render::Chart& all, const std::vector<CaseRun>& cases, const Group& group) {
    render::Chart chart = all;
    chart.curves.clear();
    // Curves that lie on each other are all seen when every second one is dashed and drawn above.
    for (const bool dashed : {false, true})
        for (std::size_t k = dashed ? 1 : 0; k < group.cases.size(); k += 2) {
            render::Curve curve = all.curves[group.cases[k]];
            if (!group.title.empty()) curve.label = cases[group.cases[k]].scheme;
            curve.colour = k;
            curve.dashed = dashed;
            chart.curves.push_back(std::move(curve));
        }
    for (std::size_t k = cases.size(); k < all.curves.size(); ++k) chart.curves.push_back(all.curves[k]);
    if (!group.title.empty()) chart.title = group.title + ": " + chart.title;
    return chart;
}

constexpr std::size_t most_across = 4;

}  // namespace

render::Page make_scheme_page(const std::vector<CaseRun>& cases, const CaseTable& table) {
    const std::vector<std::string> columns = columns_of(cases);
    const std::vector<Group> groups = groups_of(cases);
    std::vector<RecordedRun> runs;
    for (const CaseRun& each : cases) runs.push_back(each.run);
    render::Figure all = make_figure(runs, {columns, true, true});
    for (std::size_t c = 0; c < columns.size(); ++c) {
        if (columns[c] == "energy.balance") turn_over(all.charts[c]);
        all.charts[c].y_range = sound_range(all.charts[c], cases);
    }
    const std::size_t across = std::min(groups.size(), most_across),
                      down = (groups.size() + across - 1) / across * columns.size();
    constexpr double chart_height = 480, line_height = 36;
    const double charts_height = chart_height * static_cast<double>(down),
                 table_height = line_height * static_cast<double>(cases.size() + 2),
                 height = charts_height + table_height + 60;

    render::Page page;
    page.title = cases.front().run.setup->scene.title;
    page.width = static_cast<int>(std::max<std::size_t>(2000, 1000 * across));
    page.height = static_cast<int>(height);
    page.type = 1.4;
    for (std::size_t g = 0; g < groups.size(); ++g)
        for (std::size_t c = 0; c < columns.size(); ++c) {
            const double row = static_cast<double>(g / across * columns.size() + c) * chart_height;
            page.panels.push_back({chart_of(all.charts[c], cases, groups[g]),
                                   {static_cast<double>(g % across) / static_cast<double>(across),
                                    row / height, 1 / static_cast<double>(across), chart_height / height}});
        }
    render::Table shown;
    shown.title = "What each came to";
    auto rows = table.rows();
    shown.header = std::move(rows.front());
    shown.rows.assign(std::make_move_iterator(rows.begin() + 1), std::make_move_iterator(rows.end()));
    page.panels.push_back(
        {std::move(shown), {0.01, (charts_height + 20) / height, 0.98, table_height / height}});
    return page;
}

}  // namespace percuss::app
