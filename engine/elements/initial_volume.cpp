#include "elements/initial_volume.hpp"

#define PERCUSS_ISA baseline
#include "elements/kinematics.hpp"

namespace percuss {
namespace {

double triangle_volume(const Vec2& a, const Vec2& b, const Vec2& c, Geometry geometry) {
    const double x21 = b.x() - a.x(), x31 = c.x() - a.x(), y21 = b.y() - a.y(), y31 = c.y() - a.y();
    const double twice_area = x21 * y31 - x31 * y21;
    const double radius = geometry == Geometry::axisymmetric ? (a.x() + b.x() + c.x()) * (1.0 / 3.0) : 1.0;
    return 0.5 * twice_area * radius;
}

double quad_volume(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d, Geometry geometry) {
    using namespace baseline;
    const auto g = quad_geometry(to_modes(a.x(), b.x(), c.x(), d.x()), to_modes(a.y(), b.y(), c.y(), d.y()));
    return geometry == Geometry::axisymmetric ? quad_integrals<double, Geometry::axisymmetric>(g).volume
                                              : quad_integrals<double, Geometry::plane_strain>(g).volume;
}

}  // namespace

double unstressed_volume(const Batch& batch, const std::vector<Vec2>& nodes, std::int32_t element) {
    const int block = element / block_lanes, lane = element % block_lanes;
    const auto corner = [&](int k) -> const Vec2& {
        return nodes[static_cast<std::size_t>(
            batch.nodes[static_cast<std::size_t>((block * batch.corners + k) * block_lanes + lane)])];
    };
    if (batch.corners == 3) return triangle_volume(corner(0), corner(1), corner(2), batch.geometry);
    return quad_volume(corner(0), corner(1), corner(2), corner(3), batch.geometry);
}

}  // namespace percuss
