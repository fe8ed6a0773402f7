#pragma once

#include "mesh/mesh.hpp"
#include "scene/scene.hpp"

namespace percuss {

/// Adds the scene's walls to a mesh of its bodies: an immovable slave side each, so long that no body comes
/// to its ends. Contact treats it as any other side; its nodes have no mass and their inverse mass is 0.
void append_walls(const Scene& scene, Mesh& mesh);

[[nodiscard]] const Wall* find_wall(const Scene& scene,
                                    const std::string& name);  ///< null when there is none

/// Signed distance of a point from a wall's surface, positive outside the wall [length].
[[nodiscard]] inline double distance(const Wall& wall, const Vec2& point) {
    return wall.normal.dot(point - wall.point);
}

}  // namespace percuss
