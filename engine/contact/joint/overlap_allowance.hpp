#pragma once

#include <algorithm>
#include <limits>

namespace percuss {

/// How deep something may be because it began there: an offset of its gap, so that an overlap at the start
/// is no kick. It stays what it is until the two are clear of each other. (Were it to shrink with every bit
/// that the overlap gives way, surfaces that part and come back would find the gap closed behind them: the
/// force that stops them would have done work while they parted.)
class OverlapAllowance {
  public:
    /// For something that begins inside: the first gap that it is shown says how deep.
    [[nodiscard]] static OverlapAllowance as_found() {
        OverlapAllowance allowance;
        allowance.depth_ = std::numeric_limits<double>::infinity();
        return allowance;
    }
    [[nodiscard]] bool any() const { return depth_ > 0; }
    /// Takes notice of a gap. @param clear a gap from which the two cannot meet within a step [length]
    void see(double gap, double clear) {
        if (gap > clear)
            depth_ = 0;
        else if (depth_ == std::numeric_limits<double>::infinity())
            depth_ = std::max(0.0, -gap);
    }
    void end() { depth_ = 0; }
    /// The gap that counts. @pre see() has been told of a gap
    [[nodiscard]] double counted(double gap) const { return gap + depth_; }

  private:
    double depth_ = 0;  ///< [length]
};

}  // namespace percuss
