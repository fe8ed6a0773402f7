#include "run/probes.hpp"

#include <algorithm>
#include <limits>

#include "nearest_name.hpp"

namespace percuss {
namespace {

template <class Centre>
std::int32_t nearest(std::int32_t begin, std::int32_t end, const Vec2& point, Centre centre) {
    std::int32_t best = begin;
    double best_distance = std::numeric_limits<double>::infinity();
    for (std::int32_t k = begin; k < end; ++k) {
        const double distance = (centre(k) - point).squaredNorm();
        if (distance < best_distance) {
            best = k;
            best_distance = distance;
        }
    }
    return best;
}

}  // namespace

CellValues cell_values(const Batch& batch, const Node* nodes, std::int32_t element) {
    const PlasticState plastic = plastic_state(batch, nodes, element);
    return {mean_stress(batch, nodes, element), plastic.strain, plastic.yield, plastic.temperature};
}

double read_cell(const ProbeReading& reading, const std::vector<Batch>& batches, const Node* nodes) {
    const Batch& batch = batches[static_cast<std::size_t>(reading.body)];
    CellValues values = cell_values(batch, nodes, reading.cell - batch.cell_begin);
    if (reading.ambient && batch.kernel.law_size <= 2) values.temperature = *reading.ambient;
    return reading.field.of_cell(values);
}

double read_node(const ProbeReading& reading, const Node& before, const Node& after, const Mesh& mesh) {
    const double velocity[2] = {0.5 * (before.v[0] + after.v[0]), 0.5 * (before.v[1] + after.v[1])};
    return reading.field.of_node(before.x, velocity,
                                 mesh.nodes[static_cast<std::size_t>(reading.node)].data());
}

std::string fault_of_probe(const Scene& scene, const Mesh& mesh, const Probe& probe) {
    for (const Probe& other : scene.probes)
        if (other.name == probe.name) return "there is a probe '" + probe.name + "' already";
    std::vector<std::string> bodies;
    for (const MeshBody& body : mesh.bodies) bodies.push_back(body.name);
    if (std::find(bodies.begin(), bodies.end(), probe.body) == bodies.end())
        return "probe '" + probe.name + "': unknown body '" + probe.body + "'" +
               suggest_name(probe.body, bodies);
    for (const std::string& quantity : probe.record)
        if (const std::string fault = fault_of_field(scene, "quantity", quantity); !fault.empty())
            return "probe '" + probe.name + "': " + fault;
    return "";
}

std::vector<ProbeReading> bind_probe(const Scene& scene, const Mesh& mesh, const Probe& probe) {
    const auto node_at = [&](std::int32_t node) -> Vec2 {
        return mesh.nodes[static_cast<std::size_t>(node)];
    };
    const auto centre_of = [&](std::int32_t cell) -> Vec2 {
        const Cell& corners = mesh.cells[static_cast<std::size_t>(cell)];
        const int count = corner_count(corners);
        Vec2 sum(0, 0);
        for (int i = 0; i < count; ++i) sum += node_at(corners[static_cast<std::size_t>(i)]);
        return sum / count;
    };
    const auto body = std::find_if(mesh.bodies.begin(), mesh.bodies.end(),
                                   [&](const MeshBody& b) { return b.name == probe.body; });
    std::vector<ProbeReading> readings;
    for (const std::string& quantity : probe.record) {
        ProbeReading reading;
        reading.field = find_field(scene, quantity);
        reading.body = static_cast<std::int32_t>(body - mesh.bodies.begin());
        reading.ambient = ambient_temperature(scene);
        if (reading.field.per_cell) {
            reading.cell = nearest(body->cell_begin, body->cell_end, probe.at, centre_of);
        } else {
            reading.node = nearest(body->node_begin, body->node_end, probe.at, node_at);
        }
        readings.push_back(std::move(reading));
    }
    return readings;
}

std::vector<ProbeReading> bind_probes(const Scene& scene, const Mesh& mesh) {
    std::vector<ProbeReading> readings;
    for (const Probe& probe : scene.probes)
        for (ProbeReading& reading : bind_probe(scene, mesh, probe)) readings.push_back(std::move(reading));
    return readings;
}

}  // namespace percuss
