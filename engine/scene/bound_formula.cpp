#include "scene/bound_formula.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace percuss {

BoundFormula::BoundFormula(const Formula& formula) : formula_(&formula), expression_(formula.text) {
    for (const auto& [name, value] : formula.parameters) expression_.set(name, value);
    for (const auto& name : expression_.names()) {
        const auto is_own = [&](const auto& parameter) { return parameter.first == name; };
        if (std::none_of(formula.parameters.begin(), formula.parameters.end(), is_own))
            variables_.emplace_back(name, 0.0);
    }
}

void BoundFormula::set(std::string_view variable, double value) {
    expression_.set(variable, value);
    for (auto& [name, last] : variables_)
        if (name == variable) last = value;
}

double BoundFormula::value() {
    try {
        return expression_.value();
    } catch (const ExpressionError& error) {
        std::string where;
        for (const auto& [name, value] : variables_)
            where += fmt::format("{}{} = {:.9g}", where.empty() ? " at " : ", ", name, value);
        throw FormulaError(*formula_, fmt::format("has no value{}: {}", where, error.what()));
    }
}

}  // namespace percuss
