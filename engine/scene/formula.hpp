#pragma once

#include <array>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "scene/place.hpp"

namespace percuss {

/// An expression of variables that change from node to node; the scene's parameters in it have their values.
struct Formula {
    std::string text;  ///< as written, without the leading "="
    std::vector<std::pair<std::string, double>> parameters;
    Place place;
    bool operator==(const Formula&) const = default;
};

/// Formulas for one or both coordinates, with the names of the coordinates: r and z, or x and y.
struct CoordinateFormulas {
    std::array<std::optional<Formula>, 2> by;
    std::array<std::string, 2> names{"x", "y"};
    [[nodiscard]] bool any() const { return by[0] || by[1]; }
    bool operator==(const CoordinateFormulas&) const = default;
};

/// A formula that has no value where it is needed.
class FormulaError : public std::invalid_argument {
  public:
    FormulaError(const Formula& formula, const std::string& reason)
        : std::invalid_argument("the formula \"=" + formula.text + "\" " + reason), place_(formula.place) {}
    [[nodiscard]] const Place& place() const { return place_; }

  private:
    Place place_;
};

}  // namespace percuss
