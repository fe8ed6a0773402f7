#include "effects.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace percuss {

std::vector<EffectInfo> effects_of(const Scene& scene) {
    const auto any_body = [&](auto condition) {
        return std::any_of(scene.bodies.begin(), scene.bodies.end(), condition);
    };
    const auto any_of_kind = [&](ElementKind kind) {
        return any_body([&](const Body& body) { return body.element == kind; });
    };
    std::vector<EffectInfo> effects;
    effects.push_back({"one-point quads", any_of_kind(ElementKind::quad_one_point),
                       "about 255 flops and 24 bytes of state an element"});
    effects.push_back({"hourglass stiffness", any_body([](const Body& b) {
                           return b.element == ElementKind::quad_one_point && b.hourglass > 0;
                       }),
                       "about 40 flops and 16 bytes of state a one-point quad"});
    effects.push_back({"mean-dilatation quads", any_of_kind(ElementKind::quad_mean_dilatation),
                       "about 850 flops and 96 bytes of state an element"});
    effects.push_back({"triangles", any_of_kind(ElementKind::triangle),
                       "about 150 flops and 24 bytes of state an element"});
    effects.push_back(
        {"averaged triangles", any_of_kind(ElementKind::triangle_averaged),
         "about 170 flops and 44 bytes an element, 12 flops and 44 bytes a node; two more passes a step"});
    effects.push_back({"bulk viscosity", any_body([&](const Body& body) {
                           return std::any_of(scene.materials.begin(), scene.materials.end(),
                                              [&](const Material& m) {
                                                  return m.name == body.material && m.viscosity.has_value();
                                              });
                       }),
                       "about 20 flops and a square root an element; lowers the critical step"});
    const auto any_law = [&](std::size_t law) {
        return any_body([&](const Body& body) {
            return std::any_of(scene.materials.begin(), scene.materials.end(), [&](const Material& m) {
                return m.name == body.material && m.plasticity.index() == law;
            });
        });
    };
    effects.push_back({"plasticity: linear and Voce hardening", any_law(1),
                       "about 10 flops and 16 bytes of state a point; 70 flops, a root and 3 divisions where any "
                       "of eight yields"});
    effects.push_back(
        {"plasticity: tabulated hardening", any_law(2),
         "about 10 flops and 16 bytes of state a point; 25 flops, a root and 3 divisions where it yields"});
    effects.push_back({"plasticity: Johnson-Cook", any_law(3),
                       "about 10 flops and 24 bytes of state a point; about 5 iterations with 3 powers and a "
                       "logarithm where it yields"});
    effects.push_back({"body force",
                       any_body([](const Body& b) { return b.body_force[0] != 0 || b.body_force[1] != 0; }),
                       "6 flops and 16 bytes a node"});
    effects.push_back({"pressure and traction", any_body([](const Body& b) { return !b.loads.empty(); }),
                       "about 30 flops a loaded side"});
    effects.push_back({"prescribed velocity", any_body([](const Body& b) { return !b.prescribed.empty(); }),
                       "about 20 flops a prescribed node; 16 bytes a node"});
    const auto pairs_by = [&](ContactScheme scheme) {
        return !scene.contacts.empty() && scene.contact_solver.scheme == scheme;
    };
    effects.push_back(
        {"contact: projection, pair by pair", pairs_by(ContactScheme::projection),
         "motion bound on each surface node; search, solve and correction of penetrating nodes only"});
    effects.push_back(
        {"contact: joint problem", pairs_by(ContactScheme::joint),
         "motion bound on each surface node; search of near nodes; one factorisation of the rows in touch"});
    effects.push_back({"contact: penalty", pairs_by(ContactScheme::penalty),
                       "motion bound on each surface node; search of near nodes; about 60 flops a row in "
                       "reach; lowers the critical step"});
    effects.push_back(
        {"contact: massless nodes", pairs_by(ContactScheme::massless),
         "stiffness of the elements behind the surfaces and one factorisation of all their nodes"});
    effects.push_back({"contact: bipenalty", pairs_by(ContactScheme::bipenalty),
                       "as the joint problem, of the rows that are inside"});
    effects.push_back(
        {"friction", has_friction(scene),
         "a second problem for the tangents of the rows with friction, solved in turn with the first"});
    effects.push_back({"viscosity of contact layers",
                       std::any_of(scene.contacts.begin(), scene.contacts.end(),
                                   [](const ContactPair& pair) { return pair.layer.has_value(); }),
                       "about 150 flops an element of the layers; lowers the critical step"});
    effects.push_back(
        {"lagged stresses", scene.lagged, "a second copy of the node positions: 48 bytes a node"});
    effects.push_back({"probes", !scene.probes.empty(), "one stress or node reading a probe and step"});
    return effects;
}

}  // namespace percuss
