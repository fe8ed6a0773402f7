#pragma once

#include <optional>
#include <string>
#include <vector>

#include "figures/page.hpp"
#include "figures/run_figure.hpp"

namespace percuss::app {

/// One run of a scene among others by other contact schemes, steps or values.
struct CaseRun {
    std::string scheme;   ///< named_schemes.hpp
    std::string variant;  ///< "Δt 0.5", "mesh 10, Δt 0.5"; "" when the scheme is all that differs
    bool diverged = false;
    RecordedRun run;  ///< its label tells it from the others; it has no frames
};

/// What the cases came to: a row a case.
struct CaseTable {
    struct Column {
        std::string title, unit;
        std::vector<std::optional<double>> values;
        bool whole = false;  ///< counts
    };
    std::vector<std::string> labels, states;  ///< "", or "diverged at 12.3 µs"
    std::vector<Column> columns;
    std::vector<std::string> notes;  ///< what the columns are about

    /// As they are printed and drawn; "" where there is no number. The header first.
    [[nodiscard]] std::vector<std::vector<std::string>> rows() const;
    [[nodiscard]] std::string csv() const;
};
/// @pre cases are of one scene and not empty
[[nodiscard]] CaseTable make_case_table(const std::vector<CaseRun>& cases);

/// Contact force and energy of all cases against time, side by side for each variant when there are several
/// schemes, and the table.
[[nodiscard]] render::Page make_scheme_page(const std::vector<CaseRun>& cases, const CaseTable& table);

/// The history that cases are judged by: that of the scene's exact answer, a contact force before others,
/// else the largest contact force.
[[nodiscard]] std::string judged_column(const std::vector<CaseRun>& cases);
/// The contact force that is drawn: the judged one if it is one, else the largest.
[[nodiscard]] std::string force_column(const std::vector<CaseRun>& cases);

}  // namespace percuss::app
