#include "view/colour_range.hpp"

#include <algorithm>
#include <cmath>

namespace percuss::render {

ColourRange colour_range(const std::vector<double>& values, const ViewOptions& options, bool diverging,
                         double natural_size) {
    if (options.range) return *options.range;
    double low = 0, high = 0;
    bool first = true;
    for (const double value : values) {
        if (!std::isfinite(value)) continue;
        low = first ? value : std::min(low, value);
        high = first ? value : std::max(high, value);
        first = false;
    }
    const double noise = 1e-9 * natural_size;
    if (high - low <= noise) {
        const double constant = std::max(std::abs(low), std::abs(high)) <= noise ? 0 : low;
        return {constant, constant};
    }
    if (diverging) {
        const double reach = std::max(std::abs(low), std::abs(high));
        return {-reach, reach};
    }
    return {low, high};
}

double natural_size(const RunSetup& setup, const FieldInfo& field) {
    double size = 0;
    if (field.quantity == Quantity::stress) {
        for (const Material& material : setup.scene.materials) size = std::max(size, material.young);
        size *= 1e-3;  // a strain that is small, not noise
    } else if (field.quantity == Quantity::velocity) {
        for (const Body& body : setup.scene.bodies)
            size = std::max(size, std::hypot(body.velocity[0], body.velocity[1]));
    } else if (field.quantity == Quantity::length && !setup.mesh.nodes.empty()) {
        Vec2 low = setup.mesh.nodes.front(), high = low;
        for (const Vec2& node : setup.mesh.nodes) {
            low = low.cwiseMin(node);
            high = high.cwiseMax(node);
        }
        size = (high - low).norm();
    }
    return size;
}

}  // namespace percuss::render
