#include "elements/nodal_volume.hpp"

#define PERCUSS_ISA baseline
#include "elements/kinematics.hpp"

namespace percuss {

void build_nodal_volumes(Batch& batch, std::int32_t node_begin, std::int32_t node_end) {
    NodalVolumes& shared = batch.shared;
    const auto count = static_cast<std::size_t>(node_end - node_begin);
    shared.node_begin = node_begin;
    shared.nodes.assign(count, {});
    shared.elements.assign(
        static_cast<std::size_t>(batch.blocks() * batch.kernel.volume_components * block_lanes), 0);
    shared.initial_thrice.assign(count, 0);
    std::vector<std::vector<std::int32_t>> of_node(count);
    for (std::int32_t element = 0; element < batch.count; ++element) {
        const int block = element / block_lanes, lane = element % block_lanes;
        for (int corner = 0; corner < batch.corners; ++corner) {
            const auto node = static_cast<std::size_t>(
                batch.nodes[static_cast<std::size_t>((block * batch.corners + corner) * block_lanes + lane)] -
                node_begin);
            of_node[node].push_back(block * batch.kernel.volume_components * block_lanes + lane);
            shared.initial_thrice[node] += batch.volume[static_cast<std::size_t>(element)];
        }
    }
    shared.begin.assign(1, 0);
    for (const auto& places : of_node) {
        shared.places.insert(shared.places.end(), places.begin(), places.end());
        shared.begin.push_back(static_cast<std::int32_t>(shared.places.size()));
    }
}

void sum_nodal_volumes(Batch& batch, std::int32_t begin, std::int32_t end) {
    NodalVolumes& shared = batch.shared;
    const ElasticConstants& material = batch.material;
    const bool viscous = batch.kernel.volume_components > 1;
    for (auto n = static_cast<std::size_t>(begin - shared.node_begin);
         n < static_cast<std::size_t>(end - shared.node_begin); ++n) {
        const auto first = static_cast<std::size_t>(shared.begin[n]),
                   last = static_cast<std::size_t>(shared.begin[n + 1]);
        double volume = 0;
        for (std::size_t k = first; k < last; ++k)
            volume += shared.elements[static_cast<std::size_t>(shared.places[k])];
        NodalVolume& node = shared.nodes[n];
        node.ratio = volume / shared.initial_thrice[n];
        node.stress = baseline::mean_stress_of_volume(1 / node.ratio, material.bulk);
        if (!viscous) continue;

        double rate = 0, size = 0;
        for (std::size_t k = first; k < last; ++k) {
            const double* element = shared.elements.data() + shared.places[k];
            rate += element[block_lanes];
            size += element[2 * block_lanes];
        }
        rate /= volume;
        size /= static_cast<double>(last - first);
        const double density = material.density / node.ratio;
        node.viscous = baseline::bulk_viscosity(rate, density, size * size, material);
        node.damping = density * size *
                       (material.viscosity_linear * std::sqrt(material.p_wave / density) +
                        2 * material.viscosity_quadratic * size * std::abs(rate));
    }
}

void average_volumes(Batch& batch, const Node* nodes) {
    if (!batch.kernel.volumes) return;
    batch.kernel.volumes(batch, nodes, 0, batch.blocks());
    const auto count = static_cast<std::int32_t>(batch.shared.nodes.size());
    sum_nodal_volumes(batch, batch.shared.node_begin, batch.shared.node_begin + count);
}

}  // namespace percuss
