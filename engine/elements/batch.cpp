#include "elements/batch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "elements/initial_volume.hpp"
#include "elements/kernels.hpp"
#include "materials/johnson_cook_yield.hpp"

namespace percuss {
namespace {

/// Exact quadrature of shape functions over one cell: calls visit(N_1..4, weight) with sum of weights =
/// volume per radian or unit thickness. 2 x 2 Gauss points are exact for N_I r J (degree 3 in each
/// direction).
template <class Visit>
void integrate_quad(const std::array<Vec2, 4>& x, Geometry geometry, Visit visit) {
    const double gauss = 1 / std::sqrt(3.0);
    for (const double p : {-gauss, gauss}) {
        for (const double e : {-gauss, gauss}) {
            const std::array<double, 4> shape{0.25 * (1 - p) * (1 - e), 0.25 * (1 + p) * (1 - e),
                                              0.25 * (1 + p) * (1 + e), 0.25 * (1 - p) * (1 + e)};
            const Vec2 along_p = 0.25 * ((1 - e) * (x[1] - x[0]) + (1 + e) * (x[2] - x[3]));
            const Vec2 along_e = 0.25 * ((1 - p) * (x[3] - x[0]) + (1 + p) * (x[2] - x[1]));
            double weight = along_p.x() * along_e.y() - along_p.y() * along_e.x();
            if (geometry == Geometry::axisymmetric) {
                double radius = 0;
                for (int i = 0; i < 4; ++i)
                    radius += shape[static_cast<std::size_t>(i)] * x[static_cast<std::size_t>(i)].x();
                weight *= radius;
            }
            visit(shape, weight);
        }
    }
}

double triangle_area(const Vec2& a, const Vec2& b, const Vec2& c) {
    return 0.5 * ((b.x() - a.x()) * (c.y() - a.y()) - (c.x() - a.x()) * (b.y() - a.y()));
}

}  // namespace

ElasticConstants elastic_constants(const Material& material, const Body& body, Geometry geometry) {
    ElasticConstants c;
    const double e = material.young, nu = material.poisson;
    c.density = material.density;
    c.shear = e / (2 * (1 + nu));
    if (geometry == Geometry::plane_stress) {
        c.bulk = e / (2 * (1 - nu));
        c.p_wave = e / (1 - nu * nu);
    } else {
        c.bulk = e / (3 * (1 - 2 * nu));
        c.p_wave = c.bulk + 4.0 / 3.0 * c.shear;
    }
    if (material.viscosity) {
        c.viscosity_linear = material.viscosity->linear;
        c.viscosity_quadratic = material.viscosity->quadratic;
    }
    c.hourglass = body.hourglass;
    return c;
}

namespace {

/// Strain, yield stress and temperature of a point that has not flowed yet.
std::array<double, 3> initial_law_state(const Plasticity& plasticity) {
    if (const auto* voce = std::get_if<VoceHardening>(&plasticity)) return {0, voce->yield, 0};
    if (const auto* table = std::get_if<TabulatedHardening>(&plasticity))
        return {0, table->points.front().second, 0};
    const auto* law = std::get_if<JohnsonCook>(&plasticity);
    return law ? std::array{0.0, static_yield_stress(*law, 0, law->initial_temperature),
                            law->initial_temperature}
               : std::array{0.0, 0.0, 0.0};
}

struct MeanState {
    double ratio;                 // J
    double volumetric;            // energy of the bulk law per initial volume
    double pressure;              // mean stress of the bulk law
    double m, d, s;               // averaged deviator, Cauchy
    double deviator_square;       // volume average of tau:tau, Kirchhoff
    std::array<double, 3> law{};  // plastic laws: strain, yield stress, temperature
};

/// U(J), see mean_stress_of_volume.
double volumetric_energy(double bulk, double ratio) { return 0.5 * bulk * (ratio - 1) * (ratio - 1) / ratio; }

MeanState mean_state(const Batch& batch, const Node* nodes, std::int32_t element) {
    const int block = element / block_lanes, lane = element % block_lanes;
    const auto at = [&](int component) {
        return batch.state[static_cast<std::size_t>(
            (block * batch.kernel.state_size + component) * block_lanes + lane)];
    };
    Cell cell{-1, -1, -1, -1};
    for (int corner = 0; corner < batch.corners; ++corner)
        cell[static_cast<std::size_t>(corner)] =
            batch.nodes[static_cast<std::size_t>((block * batch.corners + corner) * block_lanes + lane)];
    const double initial = batch.volume[static_cast<std::size_t>(block * block_lanes + lane)];
    const double ratio = cell_volume(cell, nodes, batch.geometry) / initial;

    const double bulk = batch.material.bulk;
    MeanState mean{ratio, volumetric_energy(bulk, ratio), 0.5 * bulk * (1 - 1 / (ratio * ratio)), 0, 0, 0, 0,
                   {}};
    if (batch.kind == ElementKind::triangle_averaged) {
        mean.volumetric = mean.pressure = 0;
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const NodalVolume& node =
                batch.shared.nodes[static_cast<std::size_t>(cell[corner] - batch.shared.node_begin)];
            mean.volumetric += volumetric_energy(bulk, node.ratio) / 3;
            mean.pressure += node.stress / 3;
        }
    }
    const auto add = [&](int point, double share) {
        const int first = 3 * point;
        for (int k = 0; k < batch.kernel.law_size; ++k)
            mean.law[static_cast<std::size_t>(k)] +=
                share * at(batch.kernel.law_begin + point * batch.kernel.law_size + k);
        const double m = at(first), d = at(first + 1), s = at(first + 2);
        mean.m += share * m / ratio;
        mean.d += share * d / ratio;
        mean.s += share * s / ratio;
        mean.deviator_square += share * (6 * m * m + 2 * d * d + 2 * s * s);
    };
    if (batch.kind != ElementKind::quad_mean_dilatation) {
        add(0, 1);
        return mean;
    }
    std::array<Vec2, 4> x;
    for (std::size_t i = 0; i < 4; ++i) x[i] = {nodes[cell[i]].x[0], nodes[cell[i]].x[1]};
    // integrate_quad walks (-,-), (-,+), (+,-), (+,+); the kernel stores (-,-), (+,-), (+,+), (-,+).
    constexpr std::array<int, 4> stored{0, 3, 1, 2};
    std::size_t point = 0;
    integrate_quad(x, batch.geometry,
                   [&](const auto&, double weight) { add(stored[point++], weight / (ratio * initial)); });
    return mean;
}

}  // namespace

std::array<double, 4> corner_masses(const Cell& cell, const std::vector<Vec2>& nodes, double density,
                                    Geometry geometry) {
    std::array<double, 4> mass{0, 0, 0, 0};
    const auto at = [&](std::size_t i) { return nodes[static_cast<std::size_t>(cell[i])]; };
    if (corner_count(cell) == 3) {
        const double area = triangle_area(at(0), at(1), at(2));
        for (std::size_t i = 0; i < 3; ++i) {
            mass[i] = density * area / 3;
            if (geometry == Geometry::axisymmetric)
                mass[i] = density * area / 12 * (at(0).x() + at(1).x() + at(2).x() + at(i).x());
        }
        return mass;
    }
    integrate_quad({at(0), at(1), at(2), at(3)}, geometry,
                   [&](const std::array<double, 4>& shape, double weight) {
                       for (std::size_t i = 0; i < 4; ++i) mass[i] += density * shape[i] * weight;
                   });
    return mass;
}

double cell_volume(const Cell& cell, const Node* nodes, Geometry geometry) {
    const auto at = [&](std::size_t i) { return Vec2(nodes[cell[i]].x[0], nodes[cell[i]].x[1]); };
    if (corner_count(cell) == 3) {
        const double area = triangle_area(at(0), at(1), at(2));
        return geometry == Geometry::axisymmetric ? area * (at(0).x() + at(1).x() + at(2).x()) / 3 : area;
    }
    double volume = 0;
    integrate_quad({at(0), at(1), at(2), at(3)}, geometry,
                   [&](const auto&, double weight) { volume += weight; });
    return volume;
}

bool is_inverted(const Cell& cell, const Node* nodes, ElementKind kind, Geometry geometry) {
    if (!(cell_volume(cell, nodes, geometry) > 0)) return true;
    const auto at = [&](std::size_t i) { return Vec2(nodes[cell[i]].x[0], nodes[cell[i]].x[1]); };
    if (is_triangle(kind)) return !(triangle_area(at(0), at(1), at(2)) > 0);
    if (kind == ElementKind::quad_one_point)
        return !(triangle_area(at(0), at(1), at(2)) + triangle_area(at(0), at(2), at(3)) > 0);
    bool inverted = false;
    integrate_quad({at(0), at(1), at(2), at(3)}, Geometry::plane_strain,
                   [&](const auto&, double weight) { inverted = inverted || !(weight > 0); });
    return inverted;
}

Batch make_batch(const Scene& scene, const Mesh& mesh, std::int32_t body,
                 const std::vector<std::array<bool, 2>>& held) {
    const auto& definition = scene.bodies[static_cast<std::size_t>(body)];
    const auto& part = mesh.bodies[static_cast<std::size_t>(body)];
    const auto material = std::find_if(scene.materials.begin(), scene.materials.end(),
                                       [&](const Material& m) { return m.name == definition.material; });
    Batch batch;
    batch.body = body;
    batch.kind = part.kind;
    batch.geometry = scene.geometry;
    batch.cell_begin = part.cell_begin;
    batch.count = part.cell_end - part.cell_begin;
    batch.corners = is_triangle(part.kind) ? 3 : 4;
    batch.material = elastic_constants(*material, definition, scene.geometry);
    batch.kernel =
        find_kernel({batch.kind, batch.geometry, definition.hourglass > 0, material->viscosity.has_value(),
                     static_cast<PlasticLaw>(material->plasticity.index())},
                    best_instruction_set());

    const auto blocks = static_cast<std::size_t>(batch.blocks()),
               corners = static_cast<std::size_t>(batch.corners);
    batch.nodes.assign(blocks * corners * block_lanes, 0);
    batch.volume.assign(blocks * block_lanes, 1);
    batch.inverse_mass.assign(blocks * corners * 2 * block_lanes, 0);
    batch.plasticity = material->plasticity;
    reset_state(batch);
    batch.force.assign(blocks * corners * 2 * block_lanes, 0);
    for (std::int32_t element = 0; element < batch.count; ++element) {
        const Cell& cell = mesh.cells[static_cast<std::size_t>(batch.cell_begin + element)];
        const std::size_t block = static_cast<std::size_t>(element / block_lanes);
        const std::size_t lane = static_cast<std::size_t>(element % block_lanes);
        const auto mass = corner_masses(cell, mesh.nodes, batch.material.density, batch.geometry);
        for (std::size_t corner = 0; corner < corners; ++corner) {
            batch.nodes[(block * corners + corner) * block_lanes + lane] = cell[corner];
            for (std::size_t direction = 0; direction < 2; ++direction)
                batch.inverse_mass[((block * corners + corner) * 2 + direction) * block_lanes + lane] =
                    held[static_cast<std::size_t>(cell[corner])][direction] ? 0 : 1 / mass[corner];
        }
        batch.volume[block * block_lanes + lane] = unstressed_volume(batch, mesh.nodes, element);
    }
    if (batch.kernel.volumes) build_nodal_volumes(batch, part.node_begin, part.node_end);
    return batch;
}

void reset_state(Batch& batch) {
    const auto size = static_cast<std::size_t>(batch.kernel.state_size);
    batch.state.assign(static_cast<std::size_t>(batch.blocks()) * size * block_lanes, 0);
    if (batch.kernel.law_size == 0) return;
    const std::array<double, 3> start = initial_law_state(batch.plasticity);
    for (std::size_t block = 0; block < static_cast<std::size_t>(batch.blocks()); ++block) {
        for (int component = batch.kernel.law_begin; component < batch.kernel.state_size; ++component) {
            const int k = (component - batch.kernel.law_begin) % batch.kernel.law_size;
            const auto first =
                batch.state.begin() + static_cast<std::ptrdiff_t>(
                                          (block * size + static_cast<std::size_t>(component)) * block_lanes);
            std::fill(first, first + block_lanes, start[static_cast<std::size_t>(k)]);
        }
    }
}

PlasticState plastic_state(const Batch& batch, const Node* nodes, std::int32_t element) {
    if (batch.kernel.law_size == 0) return {0, std::numeric_limits<double>::infinity(), 0};
    const auto law = mean_state(batch, nodes, element).law;
    return {law[0], law[1], law[2]};
}

std::array<double, 4> mean_stress(const Batch& batch, const Node* nodes, std::int32_t element) {
    const MeanState s = mean_state(batch, nodes, element);
    if (batch.geometry == Geometry::plane_stress) return {s.pressure + s.d, s.pressure - s.d, 0, s.s};
    return {s.pressure + s.m + s.d, s.pressure + s.m - s.d, s.pressure - 2 * s.m, s.s};
}

double stored_energy(const Batch& batch, const Node* nodes, std::int32_t element) {
    const MeanState s = mean_state(batch, nodes, element);
    const int block = element / block_lanes, lane = element % block_lanes;
    const double initial = batch.volume[static_cast<std::size_t>(block * block_lanes + lane)];
    return initial * (s.volumetric + s.deviator_square / (4 * batch.material.shear));
}

}  // namespace percuss
