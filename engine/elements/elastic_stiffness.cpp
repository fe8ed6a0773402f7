#include "elements/elastic_stiffness.hpp"

#include <array>
#include <cmath>

#include <Eigen/LU>

namespace percuss {

namespace {

using Strains = Eigen::Matrix<double, 4, 8>;  // 11, 22, hoop, shear, by the motions of the corners
using Corners = Eigen::Matrix<double, 4, 2>;

struct Point {
    Strains strain;
    double volume;
};

Point point_of(const Corners& x, const Eigen::Vector4d& shape, const Corners& slope, double weight,
               Geometry geometry) {
    const Eigen::Matrix2d jacobian = slope.transpose() * x;
    const Corners gradient = slope * jacobian.inverse().transpose();
    const double radius = geometry == Geometry::axisymmetric ? shape.dot(x.col(0)) : 1;
    Strains strain = Strains::Zero();
    for (int i = 0; i < 4; ++i) {
        strain(0, 2 * i) = strain(3, 2 * i + 1) = gradient(i, 0);
        strain(1, 2 * i + 1) = strain(3, 2 * i) = gradient(i, 1);
        if (geometry == Geometry::axisymmetric) strain(2, 2 * i) = shape(i) / radius;
    }
    return {strain, weight * std::abs(jacobian.determinant()) * radius};
}

Point quad_point(const Corners& x, double xi, double eta, double weight, Geometry geometry) {
    const Eigen::Array4d at_xi(-1, 1, 1, -1), at_eta(-1, -1, 1, 1);
    const Eigen::Array4d a = 1 + xi * at_xi, b = 1 + eta * at_eta;
    Corners slope;
    slope.col(0) = 0.25 * at_xi * b;
    slope.col(1) = 0.25 * at_eta * a;
    return point_of(x, 0.25 * a * b, slope, weight, geometry);
}

/// Flanagan & Belytschko's stiffness against the pattern of corners that no mean strain sees
/// (quad_one_point.hpp).
CellStiffness hourglass_stiffness(const Corners& x, const ElasticConstants& material, Geometry geometry) {
    const Eigen::Vector4d xi(-1, 1, 1, -1), eta(-1, -1, 1, 1), pattern(1, -1, 1, -1);
    const Eigen::Vector2d along = 0.25 * x.transpose() * xi, across = 0.25 * x.transpose() * eta,
                          twist = 0.25 * x.transpose() * pattern;
    const auto cross = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
        return a.x() * b.y() - a.y() * b.x();
    };
    const double j0 = cross(along, across), j1 = cross(along, twist), j2 = cross(twist, across);
    // In modes of the corners, c1 = xi.u/4 and so on: gamma = pattern - xi j2/j0 - eta j1/j0.
    const Eigen::Vector4d gamma = 0.25 * (pattern - j2 / j0 * xi - j1 / j0 * eta);
    const double weight = geometry == Geometry::axisymmetric ? x.col(0).mean() : 1;
    const double stiffness =
        4 * material.hourglass * material.shear * weight / j0 * (along.squaredNorm() + across.squaredNorm());
    CellStiffness sum = CellStiffness::Zero();
    for (int d = 0; d < 2; ++d)
        for (int i = 0; i < 4; ++i)
            for (int j = 0; j < 4; ++j) sum(2 * i + d, 2 * j + d) = stiffness * gamma(i) * gamma(j);
    return sum;
}

}  // namespace

CellStiffness elastic_stiffness(const Cell& cell, ElementKind kind, const Node* nodes, double dt,
                                const ElasticConstants& material, Geometry geometry) {
    Corners x = Corners::Zero();
    for (int i = 0; i < corner_count(cell); ++i) {
        const Node& node = nodes[cell[static_cast<std::size_t>(i)]];
        for (int d = 0; d < 2; ++d) x(i, d) = node.x[d] - dt * node.v[d];
    }
    const double across = material.p_wave - 2 * material.shear;  // lambda, or its counterpart in plane stress
    Eigen::Matrix4d moduli = Eigen::Matrix4d::Zero();
    moduli.topLeftCorner<3, 3>().setConstant(across);
    moduli.diagonal() << material.p_wave, material.p_wave, material.p_wave, material.shear;
    const auto of_point = [&](const Point& p) -> CellStiffness {
        return p.volume * p.strain.transpose() * moduli * p.strain;
    };
    if (is_triangle(kind)) {
        Corners slope;
        slope << -1, -1, 1, 0, 0, 1, 0, 0;
        return of_point(point_of(x, {1.0 / 3, 1.0 / 3, 1.0 / 3, 0}, slope, 0.5, geometry));
    }
    const double at = std::sqrt(1.0 / 3);
    std::array<Point, 4> points;
    Point mean{Strains::Zero(), 0};
    for (std::size_t k = 0; k < 4; ++k) {
        points[k] = quad_point(x, k % 2 ? at : -at, k / 2 ? at : -at, 1, geometry);
        mean.strain += points[k].volume * points[k].strain;
        mean.volume += points[k].volume;
    }
    mean.strain /= mean.volume;
    if (kind == ElementKind::quad_one_point)
        return of_point(mean) + hourglass_stiffness(x, material, geometry);
    CellStiffness sum = CellStiffness::Zero();
    const int directions = geometry == Geometry::axisymmetric   ? 3
                           : geometry == Geometry::plane_strain ? 3
                                                                : 2;
    for (Point& p : points) {
        const Eigen::Matrix<double, 1, 8> missing =
            (mean.strain - p.strain).topRows<3>().colwise().sum() / directions;
        for (int d = 0; d < directions; ++d) p.strain.row(d) += missing;
        sum += of_point(p);
    }
    return sum;
}

}  // namespace percuss
