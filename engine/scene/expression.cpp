#include "scene/expression.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include <fmt/format.h>
#include <muParser.h>

#include "scene/expression_text.hpp"

namespace percuss {
namespace {

double finite(double value) {
    if (!std::isfinite(value)) throw ExpressionError("the result is not a finite number");
    return value;
}

double divide(double a, double b) {
    if (b == 0) throw ExpressionError("division by zero");
    return finite(a / b);
}

using Unary = double (*)(double);
using Binary = double (*)(double, double);
using Many = double (*)(const double*, int);

// Results are checked one by one: 1/(1/0) or min(0/0, 1) must not pass because their end is finite.
const std::map<std::string, Unary>& unary_functions() {
    static const std::map<std::string, Unary> table{
        {"sin", [](double x) { return std::sin(x); }},
        {"cos", [](double x) { return std::cos(x); }},
        {"tan", [](double x) { return finite(std::tan(x)); }},
        {"asin", [](double x) { return finite(std::asin(x)); }},
        {"acos", [](double x) { return finite(std::acos(x)); }},
        {"atan", [](double x) { return std::atan(x); }},
        {"sinh", [](double x) { return finite(std::sinh(x)); }},
        {"cosh", [](double x) { return finite(std::cosh(x)); }},
        {"tanh", [](double x) { return std::tanh(x); }},
        {"exp", [](double x) { return finite(std::exp(x)); }},
        {"ln", [](double x) { return finite(std::log(x)); }},
        {"log10", [](double x) { return finite(std::log10(x)); }},
        {"sqrt", [](double x) { return finite(std::sqrt(x)); }},
        {"abs", [](double x) { return std::abs(x); }},
        {"sign", [](double x) { return x > 0   ? 1.0
                                       : x < 0 ? -1.0
                                               : 0.0; }},
        {"floor", [](double x) { return std::floor(x); }},
        {"ceil", [](double x) { return std::ceil(x); }},
        {"round", [](double x) { return std::round(x); }},
    };
    return table;
}

const std::map<std::string, Binary>& binary_functions() {
    static const std::map<std::string, Binary> table{
        {"atan2", [](double y, double x) { return std::atan2(y, x); }},
        {"hypot", [](double x, double y) { return finite(std::hypot(x, y)); }},
    };
    return table;
}

const std::map<std::string, Many>& functions_of_many() {
    static const std::map<std::string, Many> table{
        {"min", [](const double* x,
                   int count) { return count < 1 ? finite(NAN) : *std::min_element(x, x + count); }},
        {"max", [](const double* x,
                   int count) { return count < 1 ? finite(NAN) : *std::max_element(x, x + count); }},
    };
    return table;
}

void define_operators(mu::Parser& parser) {
    const auto define = [&](const char* name, Binary operation, mu::EOprtPrecedence precedence,
                            mu::EOprtAssociativity associativity = mu::oaLEFT) {
        parser.DefineOprt(name, operation, precedence, associativity, true);
    };
    define(
        "+", [](double a, double b) { return finite(a + b); }, mu::prADD_SUB);
    define(
        "-", [](double a, double b) { return finite(a - b); }, mu::prADD_SUB);
    define(
        "*", [](double a, double b) { return finite(a * b); }, mu::prMUL_DIV);
    define("/", divide, mu::prMUL_DIV);
    define(
        "^", [](double a, double b) { return finite(std::pow(a, b)); }, mu::prPOW, mu::oaRIGHT);
    define(
        "<", [](double a, double b) { return a < b ? 1.0 : 0.0; }, mu::prCMP);
    define(
        ">", [](double a, double b) { return a > b ? 1.0 : 0.0; }, mu::prCMP);
    define(
        "<=", [](double a, double b) { return a <= b ? 1.0 : 0.0; }, mu::prCMP);
    define(
        ">=", [](double a, double b) { return a >= b ? 1.0 : 0.0; }, mu::prCMP);
    define(
        "==", [](double a, double b) { return a == b ? 1.0 : 0.0; }, mu::prCMP);
    define(
        "!=", [](double a, double b) { return a != b ? 1.0 : 0.0; }, mu::prCMP);
    define(
        "&&", [](double a, double b) { return a != 0 && b != 0 ? 1.0 : 0.0; }, mu::prLAND);
    define(
        "||", [](double a, double b) { return a != 0 || b != 0 ? 1.0 : 0.0; }, mu::prLOR);
}

/// A parser that knows our functions only: muparser's own `log`, `rint` or `_pi` would be undocumented.
mu::Parser make_parser() {
    mu::Parser parser;
    parser.ClearFun();
    parser.ClearConst();
    parser.EnableBuiltInOprt(false);
    define_operators(parser);
    for (const auto& [name, function] : unary_functions()) parser.DefineFun(name, function);
    for (const auto& [name, function] : binary_functions()) parser.DefineFun(name, function);
    for (const auto& [name, function] : functions_of_many()) parser.DefineFun(name, function);
    parser.DefineConst("pi", std::numbers::pi);
    return parser;
}

const std::vector<std::string>& function_names() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all;
        for (const auto& entry : unary_functions()) all.push_back(entry.first);
        for (const auto& entry : binary_functions()) all.push_back(entry.first);
        for (const auto& entry : functions_of_many()) all.push_back(entry.first);
        return all;
    }();
    return names;
}

std::string explain(const mu::Parser::exception_type& error) {
    switch (error.GetCode()) {
        case mu::ecUNEXPECTED_EOF:
            return "it ends too early";
        case mu::ecTOO_MANY_PARAMS:
        case mu::ecTOO_FEW_PARAMS:
            return fmt::format("function '{}' has {} arguments", error.GetToken(),
                               error.GetCode() == mu::ecTOO_MANY_PARAMS ? "too many" : "too few");
        case mu::ecMISSING_ELSE_CLAUSE:
        case mu::ecMISPLACED_COLON:
            return "'?' and ':' do not pair; write c ? a : b";
        default:
            return fmt::format("syntax error{} at character {}",
                               error.GetToken().empty() ? "" : " near '" + error.GetToken() + "'",
                               std::max(error.GetPos(), 0) + 1);
    }
}

}  // namespace

struct Expression::Compiled {
    mu::Parser parser;
    std::vector<double> values;  // of names_; the parser holds their addresses
};

Expression::Expression(std::string_view text) : names_(names_in_expression(text, function_names())) {
    if (text.find_first_not_of(" \t") == std::string_view::npos)
        throw ExpressionError("it is empty; write e.g. \"= 2*3\"");
    names_.erase(std::remove(names_.begin(), names_.end(), "pi"), names_.end());
    compiled_ = std::make_unique<Compiled>(Compiled{make_parser(), std::vector<double>(names_.size(), 1.0)});
    try {
        for (std::size_t i = 0; i < names_.size(); ++i)
            compiled_->parser.DefineVar(names_[i], &compiled_->values[i]);
        compiled_->parser.SetExpr(std::string(text));
        // Compiling comes with the first evaluation, at values that mean nothing: only its syntax is judged.
        static_cast<void>(compiled_->parser.GetUsedVar());
    } catch (const mu::Parser::exception_type& error) {
        throw ExpressionError(explain(error));
    }
}

Expression::Expression(Expression&&) noexcept = default;
Expression& Expression::operator=(Expression&&) noexcept = default;
Expression::~Expression() = default;

void Expression::set(std::string_view name, double value) {
    const auto found = std::find(names_.begin(), names_.end(), name);
    if (found != names_.end()) compiled_->values[static_cast<std::size_t>(found - names_.begin())] = value;
}

double Expression::value() {
    try {
        return finite(compiled_->parser.Eval());
    } catch (const mu::Parser::exception_type& error) {
        throw ExpressionError(explain(error));
    }
}

const std::vector<std::string>& expression_names() {
    static const std::vector<std::string> names = [] {
        auto all = function_names();
        all.emplace_back("pi");
        return all;
    }();
    return names;
}

}  // namespace percuss
