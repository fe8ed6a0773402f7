#include <algorithm>

#include <fmt/format.h>

#include "scene/readers.hpp"

namespace percuss {

void read_walls(TableReader& root, Scene& scene) {
    for (auto& reader : root.tables("wall")) {
        Wall wall;
        wall.place = reader.place();
        wall.name = read_unique_name(reader, scene.walls, "name = \"anvil\"");
        const auto bodies = names_of(scene.bodies);
        if (std::find(bodies.begin(), bodies.end(), wall.name) != bodies.end())
            reader.error("name", fmt::format("the name '{}' is taken by a body; give the wall its own name",
                                             wall.name));
        reader.need("point", "point = [x, y] on its surface");
        if (const auto point = reader.numbers("point", 2)) wall.point = vec2(*point);
        reader.need("normal", "normal = [0, 1], pointing out of the wall");
        if (const auto normal = reader.numbers("normal", 2)) {
            wall.normal = vec2(*normal);
            if (wall.normal.norm() > 0)
                wall.normal.normalize();
            else
                reader.error("normal",
                             "'normal' has no direction; write [0, 1] for a wall that faces upwards");
        }
        reader.finish();
        scene.walls.push_back(std::move(wall));
    }
}

}  // namespace percuss
