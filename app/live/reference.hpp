#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "live/curves.hpp"
#include "run/snapshot.hpp"

namespace percuss::app {

/// A run to compare the present one with: as far as it got, which is further each frame while it is the
/// present one.
struct Reference {
    std::shared_ptr<const History> history;
    /// Its newest kept moment that is not later than a time; null while that is read from the disk.
    std::function<std::shared_ptr<const Snapshot>(double time)> moments;
    Curves curves;
    std::shared_ptr<const Snapshot>
        moment;  ///< that belongs to the one that is shown; its last one after its end

    /// Takes what the reference has come to. @param shown [time]
    void follow(double shown);
    /// Its column of that name.
    [[nodiscard]] std::optional<std::size_t> column(const std::string& name) const;
};

/// Index of a history's column; nothing when it has none of that name or is null.
[[nodiscard]] std::optional<std::size_t> column_named(const std::shared_ptr<const History>& history,
                                                      const std::string& name);

/// What a curve came to in both runs.
struct PeakDifference {
    std::string label;
    Quantity quantity = Quantity::dimensionless;
    double present = 0, reference = 0;  ///< of largest magnitude, up to where the shorter of the runs has got
};
/// Of the curves of these plots that both runs have.
[[nodiscard]] std::vector<PeakDifference> peak_differences(const std::vector<PlotInfo>& plots,
                                                           const std::vector<HistoryColumn>& columns,
                                                           Curves& present, Reference& reference);

}  // namespace percuss::app
