#include <cmath>

#include "solver.hpp"

namespace percuss {

double Solver::critical_step_by_power_iteration(int most_iterations) const {
    const std::size_t count = mass_.size();
    const auto& start = setup_->mesh.nodes;
    std::vector<Batch> batches = batches_;
    for (Batch& batch : batches) {
        // Elastic, unstressed, without viscosity: the kernel of the reference stiffness.
        batch.material.viscosity_linear = batch.material.viscosity_quadratic = 0;
    }
    // Stiffness times displacement by central differences of the internal forces about the undeformed mesh.
    double size = 0;
    for (const Vec2& x : start) size = std::max(size, x.cwiseAbs().maxCoeff());
    const double small = 1e-7 * size / std::sqrt(static_cast<double>(count));
    AlignedVector<Node> nodes(count);
    KernelSums sums;
    const auto stiffness_times = [&](const std::vector<double>& u, std::vector<double>& ku) {
        std::fill(ku.begin(), ku.end(), 0.0);
        for (const double sign : {1.0, -1.0}) {
            for (std::size_t n = 0; n < count; ++n)
                for (std::size_t d = 0; d < 2; ++d) {
                    nodes[n].v[d] = sign * small * u[2 * n + d];
                    nodes[n].x[d] = start[n][static_cast<Eigen::Index>(d)] + nodes[n].v[d];
                }
            for (Batch& batch : batches) {
                reset_state(batch);
                average_volumes(batch, nodes.data());
                batch.kernel.forces(batch, nodes.data(), 1.0, 0, batch.blocks(), sums);
                for (std::int32_t element = 0; element < batch.count; ++element)
                    for (int corner = 0; corner < batch.corners; ++corner) {
                        const auto at = static_cast<std::size_t>(
                            ((element / block_lanes) * batch.corners + corner) * block_lanes + element % block_lanes);
                        const auto n = static_cast<std::size_t>(batch.nodes[at]);
                        for (std::size_t d = 0; d < 2; ++d) ku[2 * n + d] += sign * batch.force[2 * at + d] / (2 * small);
                    }
            }
        }
    };

    std::vector<double> u(2 * count), ku(2 * count);
    for (std::size_t k = 0; k < u.size(); ++k)  // a start that is orthogonal to no mode, the same every time
        u[k] = inverse_mass_[k] > 0 ? std::sin(1.0 + 12.9898 * static_cast<double>(k)) : 0;
    double omega_squared = 0;
    for (int iteration = 0; iteration < most_iterations; ++iteration) {
        double length = 0;
        for (const double value : u) length += value * value;
        length = std::sqrt(length / static_cast<double>(count));
        for (double& value : u) value /= length;
        stiffness_times(u, ku);
        double stiffness = 0, mass = 0;
        for (std::size_t k = 0; k < u.size(); ++k) {
            stiffness += u[k] * ku[k];
            mass += mass_[k / 2] * u[k] * u[k];
            u[k] = inverse_mass_[k] * ku[k];
        }
        const double next = stiffness / mass;
        const bool settled = std::abs(next - omega_squared) < 1e-9 * next;
        omega_squared = next;
        if (settled) break;
    }
    return 2 / std::sqrt(omega_squared);
}

}  // namespace percuss
