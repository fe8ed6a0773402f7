#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace percuss {

/// What is wrong with an expression, or with its value: "division by zero".
class ExpressionError : public std::invalid_argument {
  public:
    using std::invalid_argument::invalid_argument;
};

/// An arithmetic expression of named numbers, compiled once (muparser) and evaluated for many of their
/// values. Numbers, names, + - * / ^, comparisons, && ||, c ? a : b, functions and `pi` of
/// expression_names().
class Expression {
  public:
    /// @param text without the leading "=", at most 1000 characters and 32 brackets deep.
    /// @throws ExpressionError when it is none.
    explicit Expression(std::string_view text);
    Expression(Expression&&) noexcept;
    Expression& operator=(Expression&&) noexcept;
    ~Expression();

    /// The names whose values it needs, each once.
    [[nodiscard]] const std::vector<std::string>& names() const { return names_; }
    /// Gives a name its value; without effect when the expression does not use it.
    void set(std::string_view name, double value);
    /// @throws ExpressionError where an operation has no finite result.
    [[nodiscard]] double value();

  private:
    struct Compiled;
    std::vector<std::string> names_;
    std::unique_ptr<Compiled> compiled_;
};

/// Functions and constants that every expression knows; no parameter may take such a name.
[[nodiscard]] const std::vector<std::string>& expression_names();

}  // namespace percuss
