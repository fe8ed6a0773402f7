#include "view/coloured_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "image.hpp"
#include "view/colour_map.hpp"
#include "view/legend.hpp"

namespace percuss::render {

void ColouredMesh::apply(const std::shared_ptr<const RunSetup>& setup, const ViewOptions& options,
                         vtkRenderer& stage) {
    const Scene& scene = setup->scene;
    FieldInfo found;
    try {
        found = find_field(scene, options.field);
    } catch (const std::invalid_argument& error) {
        throw RenderError(error.what());
    }
    colours = make_colour_map(options.colour_map);
    field = std::move(found);
    strip = colour_strip(*colours);
    const Plane wanted{options.up, options.mirror && scene.geometry == Geometry::axisymmetric};
    if (surface && wanted.up == plane.up && wanted.mirrored == plane.mirrored) return;
    plane = wanted;
    surface.reset();  // off the stage before the new one comes
    surface = std::make_unique<Surface>(setup->mesh, plane, stage);
    extent.emplace(*setup, plane);
}

void ColouredMesh::show(const Snapshot& snapshot, const std::vector<double>& values, ColourRange range,
                        bool edges, double apart) {
    // VTK needs a span; the middle of the table then stands for a constant field.
    const double half = range[1] > range[0] ? 0 : std::max(1.0, std::abs(range[0]));
    surface->update(snapshot.position, values, field.per_cell);
    surface->set_colours(colours, {range[0] - half, range[1] + half});
    const double opacity = edge_opacity(apart);
    surface->set_edges(edges && opacity > 0.02, opacity);
}

}  // namespace percuss::render
