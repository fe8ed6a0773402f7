#include "scene/expression_text.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "nearest_name.hpp"
#include "scene/expression.hpp"

namespace percuss {
namespace {

constexpr std::size_t most_characters = 1000, most_depth = 32;

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }

/// Walks through an expression once; what it cannot judge (the order of operators) is left to the compiler.
class Scan {
  public:
    Scan(std::string_view text, const std::vector<std::string>& functions)
        : text_(text), functions_(functions) {}

    std::vector<std::string> names() {
        if (text_.size() > most_characters)
            throw ExpressionError(
                fmt::format("it has {} characters; at most {} are read", text_.size(), most_characters));
        while (at_ < text_.size()) step();
        if (!brackets_.empty()) throw ExpressionError("a closing ')' is missing");
        return std::move(names_);
    }

  private:
    void step() {
        const char c = text_[at_];
        if (is_digit(c) || c == '.')
            number();
        else if (is_letter(c))
            name();
        else
            sign(c);
    }

    void digits() {
        while (at_ < text_.size() && is_digit(text_[at_])) ++at_;
    }

    void number() {
        const std::size_t begin = at_;
        digits();
        if (peek() == '.') ++at_, digits();
        bool good = at_ - begin > 1 || is_digit(text_[begin]);
        if (peek() == 'e' || peek() == 'E') {
            ++at_;
            if (peek() == '+' || peek() == '-') ++at_;
            good = good && is_digit(peek());
            digits();
        }
        if (!good || is_letter(peek()) || peek() == '.')
            throw ExpressionError(fmt::format("'{}' at character {} is no number; write a product as 2*x",
                                              text_.substr(begin, at_ + 1 - begin), begin + 1));
    }

    void name() {
        const std::size_t begin = at_;
        while (is_letter(peek()) || is_digit(peek())) ++at_;
        const std::string word(text_.substr(begin, at_ - begin));
        const bool function = std::find(functions_.begin(), functions_.end(), word) != functions_.end();
        skip_blanks();
        if (peek() == '(') {
            if (!function)
                throw ExpressionError(
                    fmt::format("unknown function '{}'{}", word, suggest_name(word, functions_)));
            open(true);
        } else if (function) {
            throw ExpressionError(
                fmt::format("function '{}' lacks its arguments; write {}(...)", word, word));
        } else if (std::find(names_.begin(), names_.end(), word) == names_.end()) {
            names_.push_back(word);
        }
    }

    void sign(char c) {
        if (c == '(') return open(false);
        if (c == ')') {
            if (brackets_.empty())
                throw ExpressionError(fmt::format("')' at character {} closes nothing", at_ + 1));
            brackets_.pop_back();
        } else if (c == ',') {
            if (brackets_.empty() || !brackets_.back())
                throw ExpressionError(
                    fmt::format("',' at character {} parts no arguments; numbers have points", at_ + 1));
        } else if (c == '=' && !comparison()) {
            throw ExpressionError(
                fmt::format("'=' at character {} assigns nothing here; compare by ==", at_ + 1));
        } else if (std::string_view(" \t+-*/^<>=!?:&|").find(c) == std::string_view::npos) {
            throw ExpressionError(fmt::format("character {} has no meaning in an expression", at_ + 1));
        }
        ++at_;
    }

    /// True when the '=' here belongs to ==, <=, >= or !=.
    [[nodiscard]] bool comparison() const {
        const char before = at_ > 0 ? text_[at_ - 1] : ' ',
                   after = at_ + 1 < text_.size() ? text_[at_ + 1] : ' ';
        return after == '=' || before == '=' || before == '<' || before == '>' || before == '!';
    }

    void open(bool function) {
        brackets_.push_back(function);
        if (brackets_.size() > most_depth)
            throw ExpressionError(fmt::format("its brackets are more than {} deep", most_depth));
        ++at_;
    }

    void skip_blanks() {
        while (peek() == ' ' || peek() == '\t') ++at_;
    }

    [[nodiscard]] char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }

    std::string_view text_;
    const std::vector<std::string>& functions_;
    std::size_t at_ = 0;
    std::vector<bool> brackets_;  // of each open one: whether it holds arguments
    std::vector<std::string> names_;
};

}  // namespace

std::vector<std::string> names_in_expression(std::string_view text,
                                             const std::vector<std::string>& functions) {
    return Scan(text, functions).names();
}

}  // namespace percuss
