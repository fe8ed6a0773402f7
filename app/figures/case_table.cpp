#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "figures/scheme_page.hpp"
#include "record/csv_cell.hpp"
#include "record/summary.hpp"
#include "report.hpp"
#include "run/fields.hpp"
#include "run/force_error.hpp"

namespace percuss::app {
namespace {

using Column = CaseTable::Column;
using Value = std::optional<double>;

const Scene& scene_of(const std::vector<CaseRun>& cases) { return cases.front().run.setup->scene; }

Value number(const CaseRun& of, const std::string& path, double factor = 1) {
    const auto value = summary_value(of.run.summary, path);
    return value ? Value(factor * *value) : std::nullopt;
}

template <class Of>
Column column(const std::vector<CaseRun>& cases, std::string title, std::string unit, Of of) {
    Column result{std::move(title), std::move(unit), {}};
    for (const CaseRun& each : cases) result.values.push_back(of(each));
    return result;
}

/// A number of all pairs together.
template <class Join>
Value of_pairs(const CaseRun& of, const char* key, Join join) {
    double all = 0;
    for (const ContactPair& pair : of.run.setup->scene.contacts)
        all = join(all, number(of, "contact." + pair.name + "." + key).value_or(0));
    return all;
}
constexpr auto sum = [](double a, double b) { return a + b; };
constexpr auto most = [](double a, double b) { return std::max(a, b); };

Column counts(const std::vector<CaseRun>& cases, const char* title, const char* key) {
    Column result = column(cases, title, "", [&](const CaseRun& c) { return of_pairs(c, key, sum); });
    result.whole = true;
    return result;
}

bool any(const Column& column) {
    return std::any_of(column.values.begin(), column.values.end(),
                       [](const Value& v) { return v.value_or(0) != 0; });
}

/// The finest finished run of the same scheme, of those that have its values.
const CaseRun* finest_like(const std::vector<CaseRun>& cases, const CaseRun& of) {
    const auto values = [](const CaseRun& c) { return c.run.setup->scene.parameters; };
    const CaseRun* finest = nullptr;
    for (const CaseRun& other : cases) {
        if (other.diverged || other.scheme != of.scheme || values(other) != values(of)) continue;
        if (finest == nullptr || number(other, "steps") > number(*finest, "steps")) finest = &other;
    }
    return finest;
}

double against(const RecordedRun& run, const RecordedRun& finest, const std::string& quantity,
               double window) {
    return history_error(run.history->values("time"), run.history->values(quantity),
                         finest.history->values("time"), finest.history->values(quantity), window,
                         run.setup->scene.duration);
}

/// Errors of the judged history, and what they are against.
void add_errors(const std::vector<CaseRun>& cases, CaseTable& table) {
    const Scene& scene = scene_of(cases);
    const std::string judged = judged_column(cases);
    const auto averaged = [&](double window) {
        return window > 0 ? ", averaged over " + with_unit(scene.units, Quantity::time, window) : "";
    };
    if (const ExactHistory* exact = exact_of(scene, judged)) {
        table.columns.push_back(column(cases, "error", "%", [&](const CaseRun& c) {
            return c.diverged ? std::nullopt : number(c, "exact." + judged + ".error_averaged", 100);
        }));
        table.notes.push_back(fmt::format("error: of the {}, L2, against {}{}", column_title(judged),
                                          exact->label, averaged(exact->window)));
        return;
    }
    const double window = scene.analysis.window.value_or(scene.duration / 200);
    Column errors = column(cases, "error", "%", [&](const CaseRun& c) -> Value {
        const CaseRun* finest = finest_like(cases, c);
        if (c.diverged || finest == nullptr || finest == &c) return std::nullopt;
        return 100 * against(c.run, finest->run, judged, window);
    });
    if (any(errors)) {
        table.columns.push_back(std::move(errors));
        table.notes.push_back(
            fmt::format("error: of the {}, L2, against the finest step of the same scheme (no number there), "
                        "for want of an exact answer{}",
                        column_title(judged), averaged(window)));
    } else {
        table.notes.emplace_back("no error: the scene declares no exact answer, and no scheme has two steps");
    }
}

void add_velocities(const std::vector<CaseRun>& cases, CaseTable& table) {
    const Scene& scene = scene_of(cases);
    const auto names = direction_names(scene.geometry);
    std::vector<Column> found;
    double largest = 0;
    for (const Body& body : scene.bodies)
        for (std::size_t d = scene.geometry == Geometry::axisymmetric ? 1 : 0; d < 2; ++d) {
            const std::string path = fmt::format("body.{}.velocity.{}", body.name, names[d]);
            found.push_back(column(cases, fmt::format("v {}, {}", body.name, names[d]),
                                   scene.units.label(Quantity::velocity),
                                   [&](const CaseRun& c) { return number(c, path); }));
            for (const Value& v : found.back().values) largest = std::max(largest, std::abs(v.value_or(0)));
        }
    for (Column& each : found) {
        for (Value& v : each.values)
            if (std::abs(v.value_or(0)) < 1e-12 * largest) v = v ? Value(0) : v;  // rounding
        if (std::any_of(each.values.begin(), each.values.end(),
                        [&](const Value& v) { return std::abs(v.value_or(0)) > 1e-6 * largest; }))
            table.columns.push_back(std::move(each));
    }
}

std::string pair_of(const std::string& column) {
    return column.substr(8, column.rfind('.') - 8);  // contact.NAME.direction
}

}  // namespace

std::string force_column(const std::vector<CaseRun>& cases) {
    const Scene& scene = scene_of(cases);
    for (const ExactHistory& exact : scene.exact)
        if (exact.quantity.starts_with("contact.")) return exact.quantity;
    std::string best;
    double size = -1;
    for (const ContactPair& pair : scene.contacts)
        for (const std::string& direction : direction_names(scene.geometry))
            for (const CaseRun& each : cases) {
                if (each.diverged && cases.size() > 1) continue;
                const auto peak = number(each, fmt::format("contact.{}.peak.{}.value", pair.name, direction));
                if (std::abs(peak.value_or(0)) <= size) continue;
                size = std::abs(peak.value_or(0));
                best = fmt::format("contact.{}.{}", pair.name, direction);
            }
    return !best.empty() ? best
                         : fmt::format("contact.{}.{}", scene.contacts.front().name,
                                       direction_names(scene.geometry)[1]);
}

std::string judged_column(const std::vector<CaseRun>& cases) {
    const Scene& scene = scene_of(cases);
    const std::string force = force_column(cases);
    return scene.exact.empty() || exact_of(scene, force) ? force : scene.exact.front().quantity;
}

CaseTable make_case_table(const std::vector<CaseRun>& cases) {
    const Scene& scene = scene_of(cases);
    const auto unit = [&](Quantity quantity) { return scene.units.label(quantity); };
    CaseTable table;
    for (const CaseRun& each : cases) {
        table.labels.push_back(each.run.label);
        const double at = number(each, "time").value_or(0);
        table.states.push_back(each.diverged ? "diverged at " + with_unit(scene.units, Quantity::time, at)
                                             : "");
    }
    const std::string pair = pair_of(force_column(cases));
    const auto plain = [&](const char* title, std::string of_unit, std::string path, double factor) {
        table.columns.push_back(column(cases, title, std::move(of_unit),
                                       [&](const CaseRun& c) { return number(c, path, factor); }));
    };
    plain("peak force", unit(Quantity::force), "contact." + pair + ".peak_force", 1);
    add_errors(cases, table);
    add_velocities(cases, table);
    plain("energy grown", "%", "energy.maximum_growth", 100);
    plain("lost", "%", "energy.maximum_loss", 100);
    plain("momentum drift", "", "momentum.error", 1);
    table.columns.push_back(column(cases, "penetration", unit(Quantity::length),
                                   [](const CaseRun& c) { return of_pairs(c, "max_penetration", most); }));
    if (Column pulls = counts(cases, "pulls", "negative_forces"); any(pulls)) {
        table.columns.push_back(std::move(pulls));
        table.notes.emplace_back(
            "pulls: rows whose force came out negative, which all schemes but unrestricted then drop");
    }
    table.columns.push_back(counts(cases, "open/close", "open_close_events"));
    table.columns.push_back(counts(cases, "of nodes", "node_openings"));
    plain("steps", "", "steps", 1);
    table.columns.back().whole = true;
    plain("stepping", "ms", "wall_seconds.step_total", 1e3);
    table.columns.push_back(column(cases, "a step", "µs", [](const CaseRun& c) -> Value {
        const double steps = number(c, "steps").value_or(0);
        return steps > 0 ? number(c, "wall_seconds.step_total", 1e6 / steps) : std::nullopt;
    }));
    table.notes.push_back(fmt::format(
        "peak force: of {}; penetration: deepest of all pairs; open/close: changes of pairs between touching "
        "or not, beside it openings of nodes",
        pair));
    return table;
}

std::vector<std::vector<std::string>> CaseTable::rows() const {
    std::vector<std::vector<std::string>> result(labels.size() + 1);
    result[0].emplace_back("case");
    for (const Column& each : columns)
        result[0].push_back(each.unit.empty() ? each.title : fmt::format("{} [{}]", each.title, each.unit));
    for (std::size_t i = 0; i < labels.size(); ++i) {
        result[i + 1].push_back(states[i].empty() ? labels[i] : labels[i] + ": " + states[i]);
        for (const Column& each : columns) {
            const Value& value = each.values[i];
            result[i + 1].push_back(!value       ? ""
                                    : each.whole ? fmt::format("{:.0f}", *value)
                                                 : fmt::format("{:.3g}", *value));
        }
    }
    return result;
}

std::string CaseTable::csv() const {
    std::string text = "case,state";
    for (const Column& each : columns)
        text +=
            "," + csv_cell(each.unit.empty() ? each.title : fmt::format("{} [{}]", each.title, each.unit));
    text += "\n";
    for (std::size_t i = 0; i < labels.size(); ++i) {
        text += csv_cell(labels[i]) + "," + csv_cell(states[i].empty() ? "finished" : states[i]);
        for (const Column& each : columns)
            text += each.values[i] ? fmt::format(",{:.10g}", *each.values[i]) : ",";
        text += "\n";
    }
    return text;
}

}  // namespace percuss::app
