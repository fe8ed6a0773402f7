#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "live/curves.hpp"
#include "run/snapshot.hpp"

namespace percuss::app {

/// A run to compare the present one with: as far as it got, which is further each frame while it is the present one.
struct Reference {
    std::shared_ptr<const History> history;
    std::shared_ptr<const Snapshot> last;
    Curves curves;

    /// Takes what the reference has come to. @param present_history, present what the window shows
    void follow(const std::shared_ptr<const History>& present_history, const std::shared_ptr<const Snapshot>& present);
    /// Its column of that name.
    [[nodiscard]] std::optional<std::size_t> column(const std::string& name) const;
};

/// What a curve came to in both runs.
struct PeakDifference {
    std::string label;
    Quantity quantity = Quantity::dimensionless;
    double present = 0, reference = 0;  ///< of largest magnitude, up to where the shorter of the runs has got
};
/// Of the curves of these plots that both runs have.
[[nodiscard]] std::vector<PeakDifference> peak_differences(const std::vector<PlotInfo>& plots,
                                                           const std::vector<HistoryColumn>& columns, Curves& present,
                                                           Reference& reference);

}  // namespace percuss::app
