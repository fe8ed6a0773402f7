#pragma once

#include <string>
#include <vector>

#include "scene/named_schemes.hpp"
#include "scene/scene.hpp"

namespace percuss::app {

/// An axis of a grid of cases: what is varied, and what each value sets.
struct Variation {
    struct Value {
        std::string label;                   ///< the value as it was written
        std::vector<std::string> overrides;  ///< as --set
        bool own = false;                    ///< the scene is what it would be without it
    };
    StudyAxis axis;
    std::vector<Value> values;
    std::string unit;  ///< of the parameter that is varied
    /// "step 0.9", "mesh 2 mm", "joint"
    [[nodiscard]] std::string describe(std::size_t value) const;
    /// The value that other axes are looked at with: the scene's own, else the last.
    [[nodiscard]] std::size_t home() const;
};

/// One case of a grid.
struct Combination {
    std::vector<std::size_t> at;  ///< a place in Variation::values for each axis
    /// Schemes and elements first: they take away what the scene says for others.
    std::vector<std::string> overrides;
};

/// @throws UsageError for a scheme that does not exist or that the scene cannot take, a key with a star that
/// nothing of the scene has. Whether values are valid otherwise shows when their cases are read.
[[nodiscard]] Variation make_variation(const StudyAxis& axis, const Scene& scene);

/// All combinations of values, the last axis running fastest; one empty combination without axes.
[[nodiscard]] std::vector<Combination> combine(const std::vector<Variation>& axes);

/// "KEY=1,2,3" as an axis; commas in brackets and quotes do not part. @param option how messages call it.
/// @throws UsageError.
[[nodiscard]] StudyAxis parse_axis(const std::string& text, const std::string& option);

/// Whether overrides set the key of an axis, or another key for the step where it is of steps: then there is
/// nothing to vary.
[[nodiscard]] bool is_set(const StudyAxis& axis, const std::vector<std::string>& overrides);

/// Of those `choices`, the one of that name. @throws UsageError naming the nearest, or why the scene cannot
/// take it.
const SchemeChoice& choose_scheme(const std::vector<SchemeChoice>& choices, const std::string& name,
                                  const std::string& option);

}  // namespace percuss::app
