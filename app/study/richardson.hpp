#pragma once

#include <optional>
#include <span>
#include <string>

namespace percuss::app {

/// A number that was computed with cells or steps of size h.
struct Level {
    double h = 0;  ///< any unit, > 0
    double value = 0;
};

/// Where refinement leads to.
struct Limit {
    double value = 0;
    double uncertainty = 0;       ///< of `value`, in its unit
    std::optional<double> order;  ///< observed, where three levels converge
    bool extrapolated = false;    ///< else `value` is the finest level's
    std::string how;              ///< a sentence on the formulas used
};

/// The order p with f(h) = f0 + c h^p through three levels: (f3 - f1)/(f2 - f1) = (h3^p - h1^p)/(h2^p -
/// h1^p), solved by bisection; for a constant ratio r the usual log((f3 - f2)/(f2 - f1))/log r.
/// @param levels finest first; the first three count. Nothing when they do not converge monotonously.
[[nodiscard]] std::optional<double> observed_order(std::span<const Level> levels);

/// Richardson's extrapolation f0 = f1 + (f1 - f2)/(r^p - 1) with the observed order p, at most the formal 2;
/// uncertainty by Roache's grid convergence index, 1.25 |f1 - f2|/(r^p - 1) (Roache, J. Fluids Eng. 116
/// (1994) 405). Where the order cannot be observed, or is below 1/2: the finest value, and three times the
/// range of the levels over their number less one (Eca & Hoekstra, J. Comput. Phys. 262 (2014) 104). Two
/// levels: the finest, and 3 |f1 - f2|/(r - 1), as Roache has it for two, at order 1. One: its uncertainty is
/// not known (infinite).
/// @pre levels are not empty, finest first, h ascending.
[[nodiscard]] Limit extrapolate(std::span<const Level> levels);

}  // namespace percuss::app
