#include "scene/expression.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace percuss {
namespace {

double value(const std::string& text) { return Expression(text).value(); }

std::string fault(const std::string& text) {
    try {
        static_cast<void>(value(text));
    } catch (const ExpressionError& error) {
        return error.what();
    }
    return "";
}

TEST(Expression, HasTheUsualPrecedence) {
    EXPECT_EQ(value(" 2 + 3*4 - 6/3"), 12);
    EXPECT_EQ(value("-2^2"), -4);
    EXPECT_EQ(value("2^3^2"), 512);
    EXPECT_EQ(value("2^-1"), 0.5);
    EXPECT_EQ(value("8/4/2"), 1);
    EXPECT_EQ(value("(1 + 2)*-3"), -9);
    EXPECT_EQ(value("1 < 2 && 3 >= 3 && 1 != 2 && 2 == 2"), 1);
    EXPECT_EQ(value("1 > 2 || 0 <= -1"), 0);
    EXPECT_EQ(value("1 < 2 ? 10 : 20"), 10);
    EXPECT_EQ(value("1 > 2 ? 10 : 3 > 2 ? 20 : 30"), 20);
    EXPECT_EQ(value("1.5e-3 + .5 + 2."), 2.5015);
}

TEST(Expression, KnowsItsFunctionsOnly) {
    EXPECT_EQ(value("cos(pi)"), -1);
    EXPECT_EQ(value("ln(exp(2))"), 2);
    EXPECT_EQ(value("log10(1000)"), 3);
    EXPECT_EQ(value("hypot(3, 4) + sqrt(9) + abs(-1) + sign(-7)"), 8);
    EXPECT_EQ(value("min(3, 1, 2) + max(3, 1, 2)"), 4);
    EXPECT_EQ(value("floor(1.7) + ceil(1.2) + round(2.5)"), 6);
    EXPECT_DOUBLE_EQ(value("atan2(1, -1) + asin(1) + acos(1) + atan(1)"), 1.5 * std::numbers::pi);
    EXPECT_DOUBLE_EQ(value("sinh(1) + cosh(1) - exp(1) + tanh(0) + tan(0) + sin(0)"), 0);
    for (const auto& name : expression_names()) {
        if (name == "pi") continue;
        EXPECT_EQ(fault(name), "function '" + name + "' lacks its arguments; write " + name + "(...)");
    }
    EXPECT_EQ(fault("rint(2)"), "unknown function 'rint'; did you mean 'sin'?");
    EXPECT_EQ(fault("sqr(2)"), "unknown function 'sqr'; did you mean 'sqrt'?");
}

TEST(Expression, TakesTheValuesOfItsNames) {
    Expression expression("a*r + a");
    EXPECT_EQ(expression.names(), (std::vector<std::string>{"a", "r"}));
    expression.set("a", 2);
    expression.set("unused", 7);
    for (const double r : {0.0, 1.0, 2.5}) {
        expression.set("r", r);
        EXPECT_EQ(expression.value(), 2 * r + 2);
    }
    auto moved = std::move(expression);
    moved.set("a", 1);
    EXPECT_EQ(moved.value(), 3.5);
}

TEST(Expression, HasNoValueWhereAnyOperationHasNone) {
    EXPECT_EQ(fault("1/0"), "division by zero");
    EXPECT_EQ(fault("1/(1/0)"), "division by zero");
    EXPECT_EQ(fault("0/0"), "division by zero");
    EXPECT_EQ(fault("sqrt(-1)"), "the result is not a finite number");
    EXPECT_EQ(fault("min(1, sqrt(-1))"), "the result is not a finite number");
    EXPECT_EQ(fault("10^400"), "the result is not a finite number");
    EXPECT_EQ(fault("1e999"), "syntax error near '1e999' at character 1");
    Expression guarded("r > 0 ? 1/r : 0");
    guarded.set("r", 0);
    EXPECT_EQ(guarded.value(), 0);  // only the chosen side is computed
}

TEST(Expression, TellsWhatIsWrongWithItsText) {
    EXPECT_EQ(fault(""), "it is empty; write e.g. \"= 2*3\"");
    EXPECT_EQ(fault("  "), "it is empty; write e.g. \"= 2*3\"");
    EXPECT_EQ(fault("2 +"), "it ends too early");
    EXPECT_EQ(fault("(2 + 3"), "a closing ')' is missing");
    EXPECT_EQ(fault("2 + 3)"), "')' at character 6 closes nothing");
    EXPECT_EQ(fault("2x"), "'2x' at character 1 is no number; write a product as 2*x");
    EXPECT_EQ(fault("1.2.3"), "'1.2.' at character 1 is no number; write a product as 2*x");
    EXPECT_EQ(fault("1, 2"), "',' at character 2 parts no arguments; numbers have points");
    EXPECT_EQ(fault("max((1, 2), 3)"), "',' at character 7 parts no arguments; numbers have points");
    EXPECT_EQ(fault("1 = 2"), "'=' at character 3 assigns nothing here; compare by ==");
    EXPECT_EQ(fault("2 # 3"), "character 3 has no meaning in an expression");
    EXPECT_EQ(fault("\"text\""), "character 1 has no meaning in an expression");
    EXPECT_EQ(fault("sin"), "function 'sin' lacks its arguments; write sin(...)");
    EXPECT_EQ(fault("sin(1, 2)"), "function 'sin' has too many arguments");
    EXPECT_EQ(fault("atan2(1)"), "function 'atan2' has too few arguments");
    EXPECT_NE(fault("min()"), "");
    EXPECT_NE(fault("2 * * 3"), "");
    EXPECT_NE(fault("2 & 3"), "");
    EXPECT_EQ(fault("1 ? 2"), "'?' and ':' do not pair; write c ? a : b");
}

TEST(Expression, IsBoundedInLengthAndDepth) {
    const auto nested = [](int depth) {
        return std::string(static_cast<std::size_t>(depth), '(') + "1" +
               std::string(static_cast<std::size_t>(depth), ')');
    };
    EXPECT_EQ(fault(nested(32)), "");
    EXPECT_EQ(fault(nested(33)), "its brackets are more than 32 deep");
    std::string longest = "1";
    while (longest.size() < 999) longest += "+1";
    EXPECT_EQ(value(longest), 500);
    EXPECT_EQ(fault(longest + "+1"), "it has 1001 characters; at most 1000 are read");
    EXPECT_NE(fault(std::string(999, '-') + "1"), "never");  // must return at all
    EXPECT_NE(fault(std::string(999, '^')), "");
}

}  // namespace
}  // namespace percuss
