#include "view/run_extent.hpp"

#include <algorithm>
#include <cmath>

#include "view/bodies.hpp"
#include "view/layout.hpp"

namespace percuss::render {

RunExtent::RunExtent(const RunSetup& setup, const Plane& plane) : box(initial_box(setup, plane)) {
    for (const Body& body : setup.scene.bodies)
        fastest = std::max(fastest, std::hypot(body.velocity[0], body.velocity[1]));
}

void RunExtent::follow(const Snapshot& snapshot, const Plane& plane) {
    box = grown(box, box_around(body_boxes(snapshot, plane)));
    for (const ContactForce& contact : snapshot.contact_forces) {
        const double force = std::hypot(contact.force[0], contact.force[1]);
        if (std::isfinite(force)) largest_force = std::max(largest_force, force);
    }
    for (const BodyState& body : snapshot.bodies) {
        const double speed = std::hypot(body.velocity[0], body.velocity[1]);
        if (std::isfinite(speed)) fastest = std::max(fastest, speed);
    }
}

}  // namespace percuss::render
