#pragma once

#include <memory>
#include <vector>

#include "contact/contact_method.hpp"
#include "contact/scheme.hpp"

namespace percuss {

/// Pairs one after the other in the order of the scene, as in the paper: a later pair sees what the earlier
/// ones corrected, an earlier one not what the later ones did. Where pairs share nodes that is one sweep of a
/// block Gauss-Seidel iteration.
class PairByPair final : public ContactMethod {
  public:
    PairByPair(const Scene& scene, const Mesh& mesh);

    void resolve(PredictedMotion& motion, RunStatistics& statistics) override;
    [[nodiscard]] RowSpan rows(std::size_t pair) const override { return pairs_[pair]->rows(); }
    [[nodiscard]] double penetration(std::size_t pair, const Node* nodes) const override {
        return pairs_[pair]->penetration_left(nodes);
    }
    [[nodiscard]] int negative_forces(std::size_t pair) const override {
        return pairs_[pair]->negative_forces();
    }
    [[nodiscard]] std::unique_ptr<ContactMethod> copy() const override;
    void become(const ContactMethod& other) override;
    void restart(const std::vector<std::vector<std::int32_t>>& active) override;
    void change(const std::vector<double>&, const ContactSolver&) override {}  // it has no such values

  private:
    PairByPair() = default;
    std::vector<std::unique_ptr<PairScheme>> pairs_;
};

}  // namespace percuss
