#include "elements/layer_viscosity.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "contact/joint/make_rows.hpp"
#include "scene/parse.hpp"

namespace percuss {
namespace {

struct Shape {
    std::array<std::array<double, 2>, 4> gradient{};  ///< of the volume by corner positions
    double volume = 0, length = 0;                    ///< root of the area
    std::array<std::int32_t, 4> nodes{};
    std::array<std::size_t, 4> at{};  ///< of its corners in the batch: [block][corner][lane]
};

Shape shape_of(const Batch& batch, const Node* nodes, std::int32_t element) {
    Shape shape;
    const auto corners = static_cast<std::size_t>(batch.corners);
    for (std::size_t k = 0; k < corners; ++k) {
        shape.at[k] = (static_cast<std::size_t>(element / block_lanes) * corners + k) * block_lanes +
                      static_cast<std::size_t>(element % block_lanes);
        shape.nodes[k] = batch.nodes[shape.at[k]];
    }
    double area = 0;
    for (std::size_t k = 0; k < corners; ++k) {
        const std::size_t l = (k + 1) % corners;
        const double *a = nodes[shape.nodes[k]].x, *b = nodes[shape.nodes[l]].x;
        const double rise = b[1] - a[1];
        area += 0.5 * (a[0] + b[0]) * rise;
        if (batch.geometry == Geometry::axisymmetric) {
            // int r dA = closed integral of r^2/2 dz.
            const double mean_square = (a[0] * a[0] + a[0] * b[0] + b[0] * b[0]) / 6;
            shape.volume += mean_square * rise;
            shape.gradient[k][0] += (2 * a[0] + b[0]) / 6 * rise;
            shape.gradient[l][0] += (a[0] + 2 * b[0]) / 6 * rise;
            shape.gradient[k][1] -= mean_square;
            shape.gradient[l][1] += mean_square;
        } else {
            shape.gradient[k][0] += 0.5 * rise;
            shape.gradient[l][0] += 0.5 * rise;
            shape.gradient[k][1] -= 0.5 * (a[0] + b[0]);
            shape.gradient[l][1] += 0.5 * (a[0] + b[0]);
        }
    }
    if (batch.geometry != Geometry::axisymmetric) shape.volume = area;
    shape.length = std::sqrt(area);
    return shape;
}

double present_density(const Batch& batch, std::int32_t element, double volume) {
    return batch.material.density * batch.volume[static_cast<std::size_t>(element)] / volume;
}

/// Of the elements of a body within so many layers of the given nodes, the largest coefficient.
void mark_layers(const Mesh& mesh, const MeshBody& body, const std::vector<std::int32_t>& surface,
                 const ContactLayer& layer, std::vector<double>& coefficient) {
    std::vector<char> reached(mesh.nodes.size(), 0);
    for (const std::int32_t node : surface) reached[static_cast<std::size_t>(node)] = 1;
    for (int round = 0; round < layer.layers; ++round) {
        std::vector<std::int32_t> next;
        for (std::int32_t cell = body.cell_begin; cell < body.cell_end; ++cell) {
            const Cell& corners = mesh.cells[static_cast<std::size_t>(cell)];
            const auto count = corner_count(corners);
            if (std::none_of(corners.begin(), corners.begin() + count,
                             [&](std::int32_t node) { return reached[static_cast<std::size_t>(node)]; }))
                continue;
            double& of_cell = coefficient[static_cast<std::size_t>(cell)];
            of_cell = std::max(of_cell, layer.viscosity);
            next.insert(next.end(), corners.begin(), corners.begin() + count);
        }
        for (const std::int32_t node : next) reached[static_cast<std::size_t>(node)] = 1;
    }
}

}  // namespace

LayerViscosity::LayerViscosity(const Scene& scene, const Mesh& mesh, std::span<const Batch> batches) {
    if (std::none_of(scene.contacts.begin(), scene.contacts.end(),
                     [](const ContactPair& pair) { return pair.layer.has_value(); }))
        return;
    std::vector<double> coefficient(mesh.cells.size(), 0);
    for (const ContactPair& pair : scene.contacts) {
        if (!pair.layer) continue;
        const PairSurfaces surfaces = pair_surfaces(scene, mesh, pair);  // without sides on the axis
        for (const bool of_master : {true, false}) {
            const SurfaceName* name = of_master ? &pair.master : &pair.slave;
            const auto body = std::find_if(mesh.bodies.begin(), mesh.bodies.end(),
                                           [&](const MeshBody& b) { return b.name == name->body; });
            if (body == mesh.bodies.end()) continue;  // a wall
            const Batch& batch = batches[static_cast<std::size_t>(body - mesh.bodies.begin())];
            const char* fault =
                batch.kind == ElementKind::triangle_averaged ? "averaged triangles"
                : batch.material.viscosity_linear > 0 || batch.material.viscosity_quadratic > 0
                    ? "a material with viscosity already"
                    : nullptr;
            if (fault)
                throw SceneError(
                    {fmt::format("{}: contact '{}': body '{}' has {}; leave 'layer' out or change that",
                                 describe_place(scene, pair.place), pair.name, body->name, fault)});
            mark_layers(mesh, *body, (of_master ? surfaces.master : surfaces.slave).nodes, *pair.layer,
                        coefficient);
        }
    }
    for (std::size_t b = 0; b < batches.size(); ++b)
        for (std::int32_t e = 0; e < batches[b].count; ++e)
            if (const double c = coefficient[static_cast<std::size_t>(batches[b].cell_begin + e)]; c > 0)
                elements_.push_back({b, e, c});
}

double LayerViscosity::add_to(Batch& batch, const Node* nodes, double dt, const Element& element,
                              double& kept) {
    const Shape shape = shape_of(batch, nodes, element.index);
    const auto corners = static_cast<std::size_t>(batch.corners);
    double growth = 0;  // of the volume in a unit of time
    for (std::size_t k = 0; k < corners; ++k)
        growth += shape.gradient[k][0] * nodes[shape.nodes[k]].v[0] +
                  shape.gradient[k][1] * nodes[shape.nodes[k]].v[1];
    const double density = present_density(batch, element.index, shape.volume);
    const double pressure = element.coefficient * std::sqrt(batch.material.p_wave * density) * shape.length *
                            std::max(0.0, -growth / shape.volume);
    if (pressure > 0)
        for (std::size_t k = 0; k < corners; ++k)
            for (std::size_t d = 0; d < 2; ++d)
                batch.force[2 * shape.at[k] + d] -= pressure * shape.gradient[k][d];
    // Half with the pressure at the start of the step, half with that at its end, as nodal forces work.
    const double work = -0.5 * (kept + pressure) * dt * growth;
    kept = pressure;
    return work;
}

double LayerViscosity::squared_frequency(std::span<const Batch> batches, const Node* nodes) const {
    double highest = 0, of_block = 0;
    std::size_t batch_of_block = 0;
    int block = -1;
    for (const Element& element : elements_) {
        const Batch& batch = batches[element.batch];
        if (block != element.index / block_lanes || batch_of_block != element.batch) {
            block = element.index / block_lanes;
            batch_of_block = element.batch;
            of_block = batch.kernel.frequency(batch, nodes, block, block + 1);
        }
        const Shape shape = shape_of(batch, nodes, element.index);
        const auto corners = static_cast<std::size_t>(batch.corners);
        double volumetric = 0;
        for (std::size_t k = 0; k < corners; ++k) {
            for (std::size_t d = 0; d < 2; ++d) {
                const std::size_t lane = shape.at[k] % block_lanes, corner = shape.at[k] / block_lanes;
                volumetric += shape.gradient[k][d] * shape.gradient[k][d] *
                              batch.inverse_mass[(2 * corner + d) * block_lanes + lane];
            }
        }
        // The step of a damped frequency is 2/omega (sqrt(1 + x^2) - x), x = damping / (2 omega).
        const double density = present_density(batch, element.index, shape.volume);
        const double damping = element.coefficient * std::sqrt(batch.material.p_wave * density) *
                               shape.length * volumetric / shape.volume;
        const double omega = std::sqrt(of_block + 0.25 * damping * damping) + 0.5 * damping;
        highest = std::max(highest, omega * omega);
    }
    return highest;
}

}  // namespace percuss
