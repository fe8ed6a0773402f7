#include "study/study_table.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "progress.hpp"
#include "record/csv_cell.hpp"

namespace percuss::app {
namespace {

using Rows = std::vector<std::vector<std::string>>;

std::string number(const std::optional<double>& value, const char* format = "{:.10g}") {
    return value ? fmt::format(fmt::runtime(format), *value) : "";
}

std::string uncertainty_text(const Reference& reference, double tolerance) {
    if (reference.exact) return "";
    if (!std::isfinite(reference.uncertainty)) return "unknown";
    return "± " + percent(reference.uncertainty) +
           (reference.uncertainty > tolerance ? ", above the tolerance" : "");
}

}  // namespace

CasePhases phases_of(const CaseResult& result) {
    const auto seconds = [&](const char* phase) {
        return result.number(std::string("wall_seconds.") + phase).value_or(0);
    };
    CasePhases phases{seconds("elements"), seconds("contact_search") + seconds("contact_solve"), 0};
    phases.other = std::max(0.0, seconds("step_total") - phases.elements - phases.contact);
    return phases;
}

std::string percent(double part) {
    const double value = 100 * part;
    if (value != 0 && value < 0.001) return fmt::format("{:.1e} %", value);
    return fmt::format("{:.{}f} %", value, value >= 9.995 ? 0 : value >= 0.0995 ? 2 : 3);
}

std::string time_text(double seconds) {
    if (seconds < 0.9995) return fmt::format("{:.3g} ms", 1e3 * seconds);
    return seconds < 99.5 ? fmt::format("{:.3g} s", seconds) : short_duration(seconds);
}

std::string trouble(const CaseResult& result) {
    if (result.state == CaseState::finished) return "";
    return std::string(state_name(result.state)) + (result.message.empty() ? "" : ": ") + result.message;
}

Rows study_rows(const Study& study, const std::vector<CaseResult>& results, const Evaluation& evaluation) {
    Rows rows(1);
    for (const Variation& axis : study.axes) rows[0].push_back(axis.axis.name);
    for (const StudyQuantity& quantity : study.quantities) rows[0].push_back(quantity.name);
    for (const char* title : {"time", "spread", "elements", "contact", "other", "memory", "steps", "cells"})
        rows[0].emplace_back(title);
    for (std::size_t i = 0; i < study.cases.size(); ++i) {
        const CaseResult& result = results[i];
        std::vector<std::string> row;
        for (std::size_t a = 0; a < study.axes.size(); ++a)
            row.push_back(study.axes[a].values[study.cases[i].at[a]].label);
        for (std::size_t q = 0; q < study.quantities.size(); ++q) {
            const auto& error = evaluation.errors[i][q];
            const bool own =
                std::any_of(evaluation.designs.begin(), evaluation.designs.end(), [&](const Design& design) {
                    return q < design.references.size() && design.references[q].own == i;
                });
            row.push_back(error                                 ? percent(*error)
                          : own                                 ? "reference"
                          : result.state == CaseState::finished ? ""
                                                                : state_name(result.state));
        }
        if (result.seconds.empty()) {
            row.resize(rows[0].size());
        } else {
            const CasePhases phases = phases_of(result);
            row.push_back(time_text(result.best_seconds()));
            row.push_back(result.spread() ? percent(*result.spread()) : "");
            for (const double phase : {phases.elements, phases.contact, phases.other})
                row.push_back(time_text(phase));
            row.push_back(fmt::format("{:.0f} MB", result.memory));
            row.push_back(number(result.number("steps"), "{:.0f}"));
            row.push_back(number(result.number("elements"), "{:.0f}"));
        }
        rows.push_back(std::move(row));
    }
    return rows;
}

std::string study_csv(const Study& study, const std::vector<CaseResult>& results,
                      const Evaluation& evaluation) {
    std::string text;
    for (const Variation& axis : study.axes) text += csv_cell(axis.axis.key) + ",";
    text += "state";
    for (const StudyQuantity& quantity : study.quantities)
        text += "," + csv_cell(quantity.of) + "," + csv_cell("error of " + quantity.of);
    text +=
        ",seconds,spread,core share,seconds elements,seconds contact,seconds other,memory MB,memory before "
        "MB,steps,elements,message\n";
    for (std::size_t i = 0; i < study.cases.size(); ++i) {
        const CaseResult& result = results[i];
        for (std::size_t a = 0; a < study.axes.size(); ++a)
            text += csv_cell(study.axes[a].values[study.cases[i].at[a]].label) + ",";
        text += state_name(result.state);
        for (std::size_t q = 0; q < study.quantities.size(); ++q)
            text += "," + number(evaluation.values[i][q]) + "," + number(evaluation.errors[i][q]);
        const bool ran = !result.seconds.empty();
        const CasePhases phases = phases_of(result);
        const auto put = [&](const std::optional<double>& value) {
            text += "," + (ran ? number(value, "{:.6g}") : "");
        };
        for (const std::optional<double>& value :
             {std::optional(result.best_seconds()), result.spread(), std::optional(result.core_share),
              std::optional(phases.elements), std::optional(phases.contact), std::optional(phases.other),
              std::optional(result.memory), std::optional(result.memory_before), result.number("steps"),
              result.number("elements")})
            put(value);
        text += "," + csv_cell(result.message) + "\n";
    }
    return text;
}

Rows cheapest_rows(const Study& study, const std::vector<CaseResult>& results, const Evaluation& evaluation) {
    const bool several = evaluation.designs.size() > 1;
    Rows rows{{"quantity", "reference", "uncertainty", "by", "within", "cheapest case", "error", "time"}};
    if (several) rows[0].insert(rows[0].begin(), "design");
    for (const Design& design : evaluation.designs)
        for (std::size_t q = 0; q < study.quantities.size(); ++q) {
            const Reference& reference = design.references[q];
            std::vector<std::string> row{study.quantities[q].name,
                                         reference.value ? fmt::format("{:.5g}", *reference.value) : "",
                                         uncertainty_text(reference, study.quantities[q].tolerance),
                                         reference.how, percent(study.quantities[q].tolerance)};
            if (const auto& best = design.cheapest[q]) {
                row.push_back(study.cases[*best].label);
                row.push_back(percent(*evaluation.errors[*best][q]));
                row.push_back(time_text(results[*best].best_seconds()));
            } else {
                row.insert(row.end(), {"none", "", ""});
            }
            if (several) row.insert(row.begin(), design.label);
            rows.push_back(std::move(row));
        }
    return rows;
}

Rows order_rows(const Study& study, const Evaluation& evaluation) {
    Rows rows{{"refined", "at"}};
    for (const StudyQuantity& quantity : study.quantities) rows[0].push_back(quantity.name);
    std::map<std::pair<std::size_t, std::string>, std::size_t> places;
    for (const ObservedOrder& order : evaluation.orders) {
        const auto [place, fresh] = places.emplace(std::pair(order.axis, order.series), rows.size());
        if (fresh) {
            rows.push_back({study.axes[order.axis].axis.name, order.series});
            rows.back().resize(rows[0].size());
        }
        rows[place->second][2 + order.quantity] = fmt::format("{:.2f}", order.order);
    }
    return rows;
}

}  // namespace percuss::app
