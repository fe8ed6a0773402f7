#pragma once

#include <cmath>
#include <string>

#include <Eigen/Dense>

#include "elements/kernels.hpp"

namespace percuss::testing {

/// A unit cell (one quad or two triangles) that is moved by hand: every node goes to x = F X.
struct OneElement {
    struct Options {
        ElementKind kind = ElementKind::quad_one_point;
        Geometry geometry = Geometry::plane_strain;
        double hourglass = 0.1;
        double young = 200, poisson = 0.3, density = 8;
        double inner_radius = 0;  ///< of the cell, from the axis
    };

    Batch batch;
    AlignedVector<Node> nodes;
    std::vector<Vec2> start;
    KernelSums sums;
    double internal_work = 0;  ///< of the nodal forces, by the trapezoidal rule of the leapfrog

    OneElement(const Plasticity& plasticity, const Options& o) {
        Scene scene;
        scene.geometry = o.geometry;
        Material material{"m", o.density, o.young, o.poisson, {}, {}, plasticity};
        scene.materials.push_back(material);
        Body body;
        body.material = "m";
        body.element = o.kind;
        body.hourglass = o.hourglass;
        scene.bodies.push_back(body);
        const double r = o.inner_radius;
        Mesh mesh;
        mesh.nodes = {{r, 0}, {r + 1, 0}, {r + 1, 1}, {r, 1}};
        mesh.cells = {{0, 1, 2, 3}};
        if (is_triangle(o.kind)) mesh.cells = {{0, 1, 2, -1}, {0, 2, 3, -1}};
        MeshBody part;
        part.kind = o.kind;
        part.node_end = mesh.node_count();
        part.cell_end = mesh.cell_count();
        mesh.bodies.push_back(part);
        batch = make_batch(scene, mesh, 0, std::vector<std::array<bool, 2>>(4, {false, false}));
        start = mesh.nodes;
        for (const Vec2& x : start) nodes.push_back({{x.x(), x.y()}, {0, 0}});
    }

    /// One step of length dt to the deformation gradient F of the plane (the hoop stretch is F_11).
    void move_to(const Eigen::Matrix2d& f, double dt = 1) {
        for (std::size_t n = 0; n < nodes.size(); ++n) {
            const Vec2 x = f * start[n];
            for (int d = 0; d < 2; ++d) {
                nodes[n].v[d] = (x[d] - nodes[n].x[d]) / dt;
                nodes[n].x[d] = x[d];
            }
        }
        internal_work += 0.5 * dt * power();
        average_volumes(batch, nodes.data());
        batch.kernel.forces(batch, nodes.data(), dt, 0, batch.blocks(), sums);
        internal_work += 0.5 * dt * power();
    }

    /// Power of the present corner forces with the present velocities.
    [[nodiscard]] double power() const {
        double sum = 0;
        for (int element = 0; element < batch.count; ++element)
            for (int corner = 0; corner < batch.corners; ++corner) {
                const auto at = static_cast<std::size_t>(corner * block_lanes + element);
                const Node& node = nodes[static_cast<std::size_t>(batch.nodes[at])];
                sum += batch.force[2 * at] * node.v[0] + batch.force[2 * at + 1] * node.v[1];
            }
        return sum;
    }

    [[nodiscard]] std::array<double, 4> stress(int element = 0) const {
        return mean_stress(batch, nodes.data(), element);
    }
    [[nodiscard]] PlasticState plastic(int element = 0) const {
        return plastic_state(batch, nodes.data(), element);
    }
    [[nodiscard]] double von_mises(int element = 0) const {
        const auto s = stress(element);
        const double a = s[0] - s[1], b = s[1] - s[2], c = s[2] - s[0];
        return std::sqrt(0.5 * (a * a + b * b + c * c) + 3 * s[3] * s[3]);
    }
    [[nodiscard]] double plastic_work() const {
        double sum = 0;
        for (const double lane : sums.plastic) sum += lane;
        return sum;
    }
    [[nodiscard]] double elastic_energy() const {
        double sum = 0;
        for (int element = 0; element < batch.count; ++element)
            sum += stored_energy(batch, nodes.data(), element);
        return sum;
    }
};

/// Isochoric stretch along the second direction: exp(strain) there; the other in-plane stretch keeps the
/// volume.
inline Eigen::Matrix2d isochoric(Geometry geometry, double strain) {
    const double lateral = geometry == Geometry::axisymmetric ? std::exp(-0.5 * strain) : std::exp(-strain);
    return Eigen::Vector2d(lateral, std::exp(strain)).asDiagonal();
}

/// Equivalent strain of that stretch.
inline double equivalent_strain(Geometry geometry, double strain) {
    return geometry == Geometry::axisymmetric ? strain : 2 / std::sqrt(3.0) * strain;
}

inline Eigen::Matrix2d rotation(double angle) { return Eigen::Rotation2Dd(angle).toRotationMatrix(); }

inline std::string name_of(ElementKind kind) {
    return kind == ElementKind::triangle               ? "triangle"
           : kind == ElementKind::triangle_averaged    ? "averaged triangle"
           : kind == ElementKind::quad_mean_dilatation ? "mean-dilatation quad"
                                                       : "one-point quad";
}
inline constexpr std::array all_kinds{ElementKind::quad_one_point, ElementKind::quad_mean_dilatation,
                                      ElementKind::triangle, ElementKind::triangle_averaged};
inline constexpr std::array solid_geometries{Geometry::axisymmetric, Geometry::plane_strain};

}  // namespace percuss::testing
