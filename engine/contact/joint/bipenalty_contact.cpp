#include "contact/joint/bipenalty_contact.hpp"

namespace percuss {

BipenaltyContact::BipenaltyContact(const Scene& scene, const Mesh& mesh) : PenaltyContact(scene, mesh) {
    bounds_step_ = false;
}

void BipenaltyContact::change(const std::vector<double>& friction, const ContactSolver& solver) {
    PenaltyContact::change(friction, solver);
    bounds_step_ = false;
}

void BipenaltyContact::assemble(const PredictedMotion& motion) {
    const double per_stiffness = 4 * motion.kick / motion.dt;  // dt kick k / m_p
    for (const std::int32_t k : chosen_) {
        ContactRow& row = rows_[static_cast<std::size_t>(k)];
        const double change = along(
            rows_.terms(row), [&](std::int32_t node) { return motion.forces->change(node, motion.kick); });
        row.penetration = per_stiffness * row.penetration - motion.dt * change;
    }
    JointContact::assemble(motion);
    for (std::size_t place = 0; place < coupling_.places(); ++place)
        if (has_row(place))
            coupling_.soften(static_cast<std::int32_t>(place),
                             per_stiffness / stiffness(rows_[row_index(place)]));
}

}  // namespace percuss
