#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace percuss::app {

/// A term of art that the window uses, in one or two sentences.
struct Term {
    std::vector<std::string> words;  ///< the term first, then what else names it
    std::string meaning;
};

/// By the alphabet.
[[nodiscard]] const std::vector<Term>& glossary();

/// The meaning of a term. @pre the glossary has it: one that it lacks is a fault of the program.
[[nodiscard]] const std::string& meaning_of(std::string_view term);

/// The terms that a text of the window has, whatever the case, each on a line with its meaning; "" when it
/// has none. Of terms within one another ("axial stress", "stress") the longer one counts.
[[nodiscard]] std::string explain(std::string_view text);

}  // namespace percuss::app
