#pragma once

#include <string_view>

#include "scene/expression.hpp"
#include "scene/formula.hpp"

namespace percuss {

/// A formula made ready for many evaluations. It refers to the formula, which must outlive it.
class BoundFormula {
  public:
    explicit BoundFormula(const Formula& formula);
    void set(std::string_view variable, double value);
    /// @throws FormulaError that names the formula and the values at which it has none
    [[nodiscard]] double value();

  private:
    const Formula* formula_;
    Expression expression_;
    std::vector<std::pair<std::string, double>> variables_;
};

}  // namespace percuss
