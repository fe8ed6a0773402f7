#pragma once

#include <random>
#include <string>
#include <vector>

#include <Eigen/Dense>

#include "elements/kernels.hpp"

namespace percuss::testing {

/// A mesh of one body with its batch of elements, driven by hand: positions and velocities are set, kernels
/// are called.
struct ElementMesh {
    Scene scene;
    Mesh mesh;
    std::vector<std::array<bool, 2>> held;
    std::vector<double> mass;  ///< per node
    Batch batch;
    AlignedVector<Node> nodes;
    KernelSums sums;

    struct Options {
        ElementKind kind = ElementKind::quad_one_point;
        Geometry geometry = Geometry::plane_strain;
        int columns = 3, rows = 3;
        std::array<double, 4> box{1, 0, 4, 3};  ///< min0, min1, max0, max1 of the undistorted mesh
        double distortion = 0;  ///< inner nodes move by up to this part of a cell in each direction
        bool distort_boundary = false;
        unsigned seed = 1;
        double young = 200, poisson = 0.3, density = 8;
        double hourglass = 0.1;
        std::optional<BulkViscosity> viscosity;
        bool one_way = false;   ///< triangles: all diagonals alike; else every other one is turned
        bool hold_axis = true;  ///< as the solver does on r = 0
    };

    explicit ElementMesh(const Options& o) {
        scene.geometry = o.geometry;
        scene.materials.push_back({"m", o.density, o.young, o.poisson, o.viscosity, {}, {}});
        Body body;
        body.material = "m";
        body.element = o.kind;
        body.hourglass = o.hourglass;
        scene.bodies.push_back(body);

        std::mt19937 random(o.seed);
        std::uniform_real_distribution<double> shift(-o.distortion, o.distortion);
        const double dx = (o.box[2] - o.box[0]) / o.columns, dy = (o.box[3] - o.box[1]) / o.rows;
        for (int row = 0; row <= o.rows; ++row) {
            for (int column = 0; column <= o.columns; ++column) {
                Vec2 x(o.box[0] + dx * column, o.box[1] + dy * row);
                const Vec2 moved(dx * shift(random), dy * shift(random));
                const bool inner = row > 0 && row < o.rows && column > 0 && column < o.columns;
                if (inner || (o.distort_boundary && x.x() > 0)) x += moved;
                mesh.nodes.push_back(x);
            }
        }
        for (int row = 0; row < o.rows; ++row) {
            for (int column = 0; column < o.columns; ++column) {
                const auto at = [&](int c, int r) { return (row + r) * (o.columns + 1) + column + c; };
                if (!is_triangle(o.kind)) {
                    mesh.cells.push_back({at(0, 0), at(1, 0), at(1, 1), at(0, 1)});
                } else if (o.one_way || (row + column) % 2 == 0) {
                    mesh.cells.push_back({at(0, 0), at(1, 0), at(1, 1), -1});
                    mesh.cells.push_back({at(0, 0), at(1, 1), at(0, 1), -1});
                } else {
                    mesh.cells.push_back({at(0, 0), at(1, 0), at(0, 1), -1});
                    mesh.cells.push_back({at(1, 0), at(1, 1), at(0, 1), -1});
                }
            }
        }
        MeshBody part;
        part.kind = o.kind;
        part.node_end = mesh.node_count();
        part.cell_end = mesh.cell_count();
        mesh.bodies.push_back(part);
        held.assign(mesh.nodes.size(), {false, false});
        if (o.geometry == Geometry::axisymmetric && o.hold_axis)
            for (std::size_t n = 0; n < mesh.nodes.size(); ++n) held[n][0] = mesh.nodes[n].x() == 0;
        make();
    }

    /// Makes the batch anew, after a change of `mesh`, `held` or `scene`.
    void make() {
        batch = make_batch(scene, mesh, 0, held);
        mass.assign(mesh.nodes.size(), 0);
        for (const Cell& cell : mesh.cells) {
            const auto share = corner_masses(cell, mesh.nodes, batch.material.density, scene.geometry);
            for (std::size_t i = 0; i < static_cast<std::size_t>(corner_count(cell)); ++i)
                mass[static_cast<std::size_t>(cell[i])] += share[i];
        }
        rest();
    }

    /// Back to the undeformed, unstressed state.
    void rest() {
        nodes.clear();
        for (const Vec2& x : mesh.nodes) nodes.push_back({{x.x(), x.y()}, {0, 0}});
        std::fill(batch.state.begin(), batch.state.end(), 0.0);
        std::fill(batch.force.begin(), batch.force.end(), 0.0);
        average_volumes(batch, nodes.data());
        sums = {};
    }

    [[nodiscard]] Eigen::Index dofs() const { return 2 * mesh.node_count(); }

    /// Moves every node by its displacement in one step of duration 1 and returns the internal nodal forces.
    Eigen::VectorXd move(const Eigen::VectorXd& displacement) {
        for (std::size_t n = 0; n < nodes.size(); ++n) {
            for (std::size_t d = 0; d < 2; ++d) {
                nodes[n].v[d] = displacement[static_cast<Eigen::Index>(2 * n + d)];
                nodes[n].x[d] += nodes[n].v[d];
            }
        }
        return update(1);
    }

    /// Calls the force kernel at the present positions and velocities and returns the internal nodal forces.
    Eigen::VectorXd update(double dt) {
        average_volumes(batch, nodes.data());
        batch.kernel.forces(batch, nodes.data(), dt, 0, batch.blocks(), sums);
        return internal_force();
    }

    [[nodiscard]] Eigen::VectorXd internal_force() const {
        Eigen::VectorXd force = Eigen::VectorXd::Zero(dofs());
        for (std::int32_t element = 0; element < batch.count; ++element) {
            for (int corner = 0; corner < batch.corners; ++corner) {
                const auto at = static_cast<std::size_t>(
                    ((element / block_lanes) * batch.corners + corner) * block_lanes + element % block_lanes);
                for (int d = 0; d < 2; ++d)
                    force[2 * batch.nodes[at] + d] += batch.force[2 * at + static_cast<std::size_t>(d)];
            }
        }
        return force;
    }

    /// The displacement field u(x) at the nodes' present positions.
    template <class Field>
    [[nodiscard]] Eigen::VectorXd displacement(Field field) const {
        Eigen::VectorXd u(dofs());
        for (std::size_t n = 0; n < nodes.size(); ++n)
            u.segment<2>(static_cast<Eigen::Index>(2 * n)) = field(Vec2(nodes[n].x[0], nodes[n].x[1]));
        return u;
    }

    [[nodiscard]] double energy() const {
        double sum = 0;
        for (std::int32_t element = 0; element < batch.count; ++element)
            sum += stored_energy(batch, nodes.data(), element);
        return sum;
    }

    [[nodiscard]] double hourglass_work() const {
        double sum = 0;
        for (const double lane : sums.hourglass) sum += lane;
        return sum;
    }

    /// 2 / sqrt of the kernel's bound: the element estimate of the critical step.
    [[nodiscard]] double estimated_step() {
        average_volumes(batch, nodes.data());
        return 2 / std::sqrt(batch.kernel.frequency(batch, nodes.data(), 0, batch.blocks()));
    }

    /// Stiffness about the undeformed state, column by column, by central differences of the kernel's forces:
    /// relative error (strain)^2 = 1e-12 of the law, 1e-16 / strain = 1e-10 of rounding.
    [[nodiscard]] Eigen::MatrixXd stiffness() {
        Eigen::MatrixXd k(dofs(), dofs());
        double size = 0;
        for (const Vec2& x : mesh.nodes) size = std::max(size, (x - mesh.nodes[0]).norm());
        const double small = 1e-6 * size / std::sqrt(static_cast<double>(mesh.cells.size()));
        for (Eigen::Index j = 0; j < dofs(); ++j) {
            const Eigen::VectorXd u = small * Eigen::VectorXd::Unit(dofs(), j);
            rest();
            k.col(j) = move(u);
            rest();
            k.col(j) = (k.col(j) - move(-u)).eval() / (2 * small);
        }
        rest();
        return k;
    }

    /// Indices of the degrees of freedom that are not held.
    [[nodiscard]] std::vector<Eigen::Index> free_dofs() const {
        std::vector<Eigen::Index> free;
        for (std::size_t n = 0; n < held.size(); ++n)
            for (std::size_t d = 0; d < 2; ++d)
                if (!held[n][d]) free.push_back(static_cast<Eigen::Index>(2 * n + d));
        return free;
    }

    /// 2 / omega_max of the assembled mesh by a dense symmetric eigenvalue problem.
    [[nodiscard]] double true_critical_step() {
        const auto free = free_dofs();
        Eigen::VectorXd root(dofs());
        for (Eigen::Index j = 0; j < dofs(); ++j)
            root[j] = 1 / std::sqrt(mass[static_cast<std::size_t>(j / 2)]);
        const Eigen::MatrixXd k = stiffness();
        const Eigen::MatrixXd scaled = root.asDiagonal() * (0.5 * (k + k.transpose())) * root.asDiagonal();
        const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(scaled(free, free),
                                                                    Eigen::EigenvaluesOnly);
        return 2 / std::sqrt(solver.eigenvalues().maxCoeff());
    }

    /// Leapfrog from the present state. @returns kinetic energy at the end; infinity once a speed exceeds
    /// `limit`.
    double leapfrog(double dt, int steps, double limit) {
        for (int step = 0; step < steps; ++step) {
            const Eigen::VectorXd f = internal_force();
            for (std::size_t n = 0; n < nodes.size(); ++n) {
                for (std::size_t d = 0; d < 2; ++d) {
                    double& v = nodes[n].v[d];
                    v = held[n][d] ? 0 : v - dt * f[static_cast<Eigen::Index>(2 * n + d)] / mass[n];
                    nodes[n].x[d] += dt * v;
                    if (!(std::abs(v) < limit)) return std::numeric_limits<double>::infinity();
                }
            }
            update(dt);
        }
        double energy = 0;
        for (std::size_t n = 0; n < nodes.size(); ++n)
            energy += 0.5 * mass[n] * (nodes[n].v[0] * nodes[n].v[0] + nodes[n].v[1] * nodes[n].v[1]);
        return energy;
    }

    /// The state's stress (rr, zz, hoop, shear) in one element.
    [[nodiscard]] std::array<double, 4> stress(std::int32_t element) const {
        return mean_stress(batch, nodes.data(), element);
    }
};

inline constexpr std::array<ElementKind, 4> all_kinds{ElementKind::quad_one_point,
                                                      ElementKind::quad_mean_dilatation,
                                                      ElementKind::triangle, ElementKind::triangle_averaged};
inline constexpr std::array<Geometry, 3> all_geometries{Geometry::axisymmetric, Geometry::plane_strain,
                                                        Geometry::plane_stress};

inline std::string name_of(ElementKind kind) {
    return kind == ElementKind::triangle               ? "triangle"
           : kind == ElementKind::triangle_averaged    ? "averaged triangle"
           : kind == ElementKind::quad_mean_dilatation ? "mean-dilatation quad"
                                                       : "one-point quad";
}
inline std::string name_of(Geometry geometry) {
    return geometry == Geometry::axisymmetric   ? "axisymmetric"
           : geometry == Geometry::plane_strain ? "plane strain"
                                                : "plane stress";
}

}  // namespace percuss::testing
