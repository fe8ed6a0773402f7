#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "dynamics/node.hpp"
#include "scene/scene.hpp"

namespace percuss {

/// Body forces, pressures and tractions of a scene, as nodal forces per radian (axisymmetric) or unit
/// thickness.
class Loads {
  public:
    Loads() = default;
    Loads(const Scene& scene, const Mesh& mesh);

    /// No load in the scene: nothing is stored and the step never asks again.
    [[nodiscard]] bool none() const { return !any_body_force_ && edges_.empty(); }
    /// Writes the forces at `time` and the present positions, 2 per node [force].
    void evaluate(const Node* nodes, const std::vector<double>& mass, double time,
                  std::vector<double>& force) const;
    /// Sets the flags of all nodes that ever bear a load.
    void mark_loaded(std::vector<char>& nodes) const;

  private:
    struct Span {
        std::int32_t begin, end;
        std::array<double, 2> acceleration;
    };
    struct LoadedSide {
        std::int32_t i, j;
        std::array<double, 2>
            area;  ///< initial ring area per radian at each end (traction is per initial area)
    };
    struct LoadedEdge {
        std::vector<LoadedSide> sides;
        EdgeLoad load;
    };
    std::vector<Span> bodies_;
    std::vector<LoadedEdge> edges_;
    Geometry geometry_ = Geometry::axisymmetric;
    bool any_body_force_ = false;
};

/// Velocities that the scene imposes: held directions (axis, constraints) and prescribed motion.
struct ImposedMotion {
    struct Prescribed {
        std::int32_t node;
        int direction;
        std::int32_t motion;  ///< index into `motions`
        bool acts;            ///< in the present step
    };
    std::vector<std::array<bool, 2>> held;  ///< per node: the velocity is imposed for the whole run
    std::vector<Prescribed> prescribed;
    std::vector<PrescribedVelocity> motions;
    bool timed = false;  ///< some motions begin or end within the run
};

/// @throws nothing; nodes on r = 0 of an axisymmetric mesh are held in r.
[[nodiscard]] ImposedMotion impose_motion(const Scene& scene, const Mesh& mesh);

}  // namespace percuss
