#include "report.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <fmt/format.h>

#include "progress.hpp"
#include "record/summary.hpp"

namespace percuss::app {

std::string with_unit(const Units& units, Quantity quantity, double value) {
    const DisplayUnit unit = units.display(quantity, std::abs(value));
    return fmt::format("{:.4g}{}{}", unit.scale * value, unit.label.empty() ? "" : " ", unit.label);
}

void print_aligned(const std::vector<std::vector<std::string>>& rows) {
    std::vector<std::size_t> widths(rows.front().size(), 0);
    // µ and Δ are two bytes and one letter.
    const auto letters = [](const std::string& text) {
        return static_cast<std::size_t>(
            std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
    };
    for (const auto& row : rows)
        for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], letters(row[c]));
    for (const auto& row : rows) {
        std::string line;
        for (std::size_t c = 0; c < row.size(); ++c) {
            const std::string room(widths[c] - letters(row[c]), ' ');
            line += c == 0 ? row[c] + room : "  " + room + row[c];
        }
        fmt::print("{}\n", line);
    }
}

void print_results(const Snapshot& last, const RunStatistics& statistics) {
    const Scene& scene = last.setup->scene;
    const Units& units = scene.units;
    const char* how = last.status == RunStatus::finished   ? "finished"
                      : last.status == RunStatus::diverged ? "DIVERGED"
                                                           : "interrupted";
    fmt::print("{} at {} after {} steps in {}; stepping took {}, {} element-steps/s\n", how,
               with_unit(units, Quantity::time, last.time), statistics.steps,
               short_duration(statistics.total_seconds), short_duration(statistics.step_seconds),
               short_number(statistics.step_seconds > 0
                                ? static_cast<double>(statistics.steps) *
                                      static_cast<double>(statistics.cells) / statistics.step_seconds
                                : 0));
    if (!last.message.empty()) fmt::print(stderr, "percuss: {}\n", last.message);
    fmt::print("energy: {} at the start, largest loss {:.3g} %, largest growth {:.3g} %\n",
               with_unit(units, Quantity::energy, statistics.initial_energy), 100 * statistics.maximum_loss,
               100 * statistics.maximum_growth);
    for (std::size_t p = 0; p < std::min(scene.contacts.size(), statistics.pairs.size()); ++p) {
        const PairStatistics& pair = statistics.pairs[p];
        fmt::print("contact {}: peak force {}, {} open/close events\n", scene.contacts[p].name,
                   with_unit(units, Quantity::force, pair.peak_force), pair.events);
    }
}

bool print_promises(const Scene& scene, const nlohmann::ordered_json& summary) {
    bool all = true;
    for (const ExpectationResult& result : check_expectations(scene, summary)) {
        all = all && result.kept;
        fmt::print("{} {}\n", result.kept ? "✓" : "✗", result.text);
    }
    if (!all) fmt::print(stderr, "percuss: warning: the run does not keep what its scene promises\n");
    return all;
}

}  // namespace percuss::app
