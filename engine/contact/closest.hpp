#pragma once

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
    // The root and the division do not wait for each other.
    const double square = tx * tx + ty * ty, length = std::sqrt(square), inverse_square = 1 / square;
    const double inverse = length * inverse_square;
    const double rx = x - i[0], ry = y - i[1];
    const double nx = ty * inverse, ny = -tx * inverse;
    return {(rx * tx + ry * ty) * inverse_square, rx * nx + ry * ny, nx, ny, length};
}

/// Square of the distance from a point to the side itself, its ends included [length^2]. Divides only where
/// the foot of the perpendicular lies within the side: seldom so for the neighbours of the closest one.
[[nodiscard]] inline double squared_distance(const Node* nodes, const Side& side, double x, double y) {
    const double* i = nodes[side.i].x;
    const double* j = nodes[side.j].x;
    const double tx = j[0] - i[0], ty = j[1] - i[1];
    const double rx = x - i[0], ry = y - i[1];
    const double along = rx * tx + ry * ty, square = tx * tx + ty * ty;
    if (along <= 0) return rx * rx + ry * ry;
    if (along >= square) return (x - j[0]) * (x - j[0]) + (y - j[1]) * (y - j[1]);
    const double across = rx * ty - ry * tx;
    return across * across / square;
}

}  // namespace percuss
