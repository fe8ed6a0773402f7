#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "elements/batch.hpp"
#include "mesh/mesh.hpp"
#include "scene/scene.hpp"

namespace percuss {

/// Linear bulk viscosity (Landshoff 1955; see bulk_viscosity in kinematics.hpp) in the first layers of
/// elements behind the surfaces of contact pairs only,
///     q = c1 rho c h |D| where D < 0,
/// on the exact gradient B of the element's volume: corner forces -q B. It takes the ringing that an impact
/// starts where it starts, and leaves waves further inside alone. What it takes is viscous work. The element
/// kernels know nothing of it: it comes on top of their corner forces, and only its own elements pay.
class LayerViscosity {
  public:
    LayerViscosity() = default;  ///< of no elements
    /// @throws SceneError where a layer falls on a body that has bulk viscosity already or averaged
    /// triangles.
    LayerViscosity(const Scene& scene, const Mesh& mesh, std::span<const Batch> batches);

    [[nodiscard]] bool none() const { return elements_.empty(); }
    [[nodiscard]] std::size_t size() const { return elements_.size(); }
    /// Adds the corner forces of the present motion. @param kept per element, pressures of the last step, of
    /// this one afterwards. @param visit called with body and work taken up [energy per radian or thickness]
    template <class Visit>
    void add(std::span<Batch> batches, const Node* nodes, double dt, std::vector<double>& kept,
             Visit visit) const {
        for (std::size_t k = 0; k < elements_.size(); ++k) {
            const Element& element = elements_[k];
            visit(element.batch, add_to(batches[element.batch], nodes, dt, element, kept[k]));
        }
    }
    /// The largest squared frequency of its elements, viscosity accounted for, as FrequencyKernel has it.
    [[nodiscard]] double squared_frequency(std::span<const Batch> batches, const Node* nodes) const;

  private:
    struct Element {
        std::size_t batch;
        std::int32_t index;
        double coefficient;
    };
    static double add_to(Batch& batch, const Node* nodes, double dt, const Element& element, double& kept);

    std::vector<Element> elements_;  // batch by batch, in their order
};

}  // namespace percuss
