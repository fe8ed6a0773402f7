#pragma once

#include <memory>
#include <vector>

#include "contact/predicted_motion.hpp"
#include "contact/row.hpp"
#include "contact/search.hpp"
#include "run/statistics.hpp"

namespace percuss {

/// One way to keep one pair of surfaces from penetrating. A step calls find, then resolve.
class PairScheme {
  public:
    virtual ~PairScheme() = default;
    /// Finds the contact rows at the predicted positions.
    virtual void find(const PredictedMotion& motion) = 0;
    /// Solves for the contact forces and corrects displacements and velocities.
    virtual void resolve(PredictedMotion& motion) = 0;
    /// The rows of this step with their forces, for resultants, work and pictures.
    [[nodiscard]] virtual RowSpan rows() const = 0;
    /// Largest penetration left after the correction [length].
    [[nodiscard]] virtual double penetration_left(const Node* nodes) const = 0;
    /// Rows whose unrestricted force came out negative in this step.
    [[nodiscard]] virtual int negative_forces() const = 0;
    /// A copy with all that is remembered between steps.
    [[nodiscard]] virtual std::unique_ptr<PairScheme> copy() const = 0;
    /// Goes on as `other` would, bit by bit. @pre `other` is a copy() of a scheme for the same pair.
    virtual void become(const PairScheme& other) = 0;
    /// Positions were changed from outside: forget what was remembered between steps.
    virtual void forget() = 0;
};

/// The scheme that a pair asks for. @param node_count of the mesh.
[[nodiscard]] std::unique_ptr<PairScheme> make_contact_scheme(const ContactPair& pair, const Mesh& mesh);

}  // namespace percuss
