#pragma once

#include <array>

#include "scene/scene.hpp"

namespace percuss::render {

/// How the model's two coordinates lie in the picture.
struct Plane {
    VerticalAxis up = VerticalAxis::second;
    bool mirrored = false;  ///< the half at negative first coordinate is drawn too

    /// {to the right, upwards} of a point or vector {first, second}.
    [[nodiscard]] std::array<double, 2> operator()(double first, double second) const {
        return up == VerticalAxis::second ? std::array{first, second} : std::array{second, first};
    }
    /// The picture's coordinate that mirroring negates: 0 rightwards, 1 upwards.
    [[nodiscard]] std::size_t mirror_axis() const { return up == VerticalAxis::second ? 0 : 1; }
};

}  // namespace percuss::render
