#pragma once

#include <algorithm>
#include <cmath>

#include "contact/surface.hpp"
#include "dynamics/node.hpp"

namespace percuss {

/// A point relative to the straight line through a side.
struct SideView {
    double a;       ///< length factor of the foot of the perpendicular: 0 at i, 1 at j, unclamped
    double gap;     ///< signed distance to the line, positive outside the body [length]
    double nx, ny;  ///< unit outward normal
    double length;  ///< of the side [length]
};

[[nodiscard]] inline SideView view_from_side(const Node* nodes, const Side& side, double x, double y) {
    const double* i = nodes[side.i].x;
    const double* j = nodes[side.j].x;
    const double tx = j[0] - i[0], ty = j[1] - i[1];
    const double square = tx * tx + ty * ty, inverse = 1 / std::sqrt(square);
    const double rx = x - i[0], ry = y - i[1];
    const double nx = ty * inverse, ny = -tx * inverse;
    return {(rx * tx + ry * ty) * (inverse * inverse), rx * nx + ry * ny, nx, ny, square * inverse};
}

/// Square of the distance from a point to the side itself, its ends included [length^2].
[[nodiscard]] inline double squared_distance(const Node* nodes, const Side& side, double x, double y) {
    const double* i = nodes[side.i].x;
    const double* j = nodes[side.j].x;
    const double tx = j[0] - i[0], ty = j[1] - i[1];
    const double rx = x - i[0], ry = y - i[1];
    const double a = std::clamp((rx * tx + ry * ty) / (tx * tx + ty * ty), 0.0, 1.0);
    const double dx = rx - a * tx, dy = ry - a * ty;
    return dx * dx + dy * dy;
}

}  // namespace percuss
