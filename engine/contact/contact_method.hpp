#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "contact/predicted_motion.hpp"
#include "contact/row.hpp"
#include "run/statistics.hpp"
#include "scene/scene.hpp"

namespace percuss {

/// How the pairs of a scene are kept from penetrating: chosen once, when the scene loads.
class ContactMethod {
  public:
    virtual ~ContactMethod() = default;
    /// Finds the contact rows of all pairs, solves for the contact forces and corrects displacements and
    /// velocities. Books the seconds of search and solution, and what the solver did.
    virtual void resolve(PredictedMotion& motion, RunStatistics& statistics) = 0;
    /// The rows of a pair in this step with their forces, for resultants, work and pictures.
    [[nodiscard]] virtual RowSpan rows(std::size_t pair) const = 0;
    /// The same for friction, whose rows are those of contact turned by 90 degrees and whose forces may have
    /// either sign. Empty for pairs without friction.
    [[nodiscard]] virtual RowSpan friction_rows(std::size_t) const { return {}; }
    /// Rows of a pair that touch and do not slide.
    [[nodiscard]] virtual int sticking(std::size_t) const { return 0; }
    /// Largest penetration of a pair that the step has seen [length].
    [[nodiscard]] virtual double penetration(std::size_t pair, const Node* nodes) const = 0;
    /// Rows of a pair whose unrestricted force came out negative in this step.
    [[nodiscard]] virtual int negative_forces(std::size_t pair) const = 0;
    /// A copy with all that is remembered between steps.
    [[nodiscard]] virtual std::unique_ptr<ContactMethod> copy() const = 0;
    /// Goes on as `other` would, bit by bit. @pre `other` is a copy() of a method for the same scene.
    virtual void become(const ContactMethod& other) = 0;
    /// Positions were changed from outside: forgets what was remembered between steps, but for the master
    /// nodes of each pair that had force in the last one.
    virtual void restart(const std::vector<std::vector<std::int32_t>>& active) = 0;
    /// Goes on with other values. @param friction coefficient per pair, above 0 where it was before
    virtual void change(const std::vector<double>& friction, const ContactSolver& solver) = 0;
};

/// The method for a scene with this scheme; null when it has no contact pairs.
[[nodiscard]] std::unique_ptr<ContactMethod> make_contact_method(const Scene& scene, const Mesh& mesh,
                                                                 ContactScheme scheme);

}  // namespace percuss
