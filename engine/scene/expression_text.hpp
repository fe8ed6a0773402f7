#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace percuss {

/// Checks what can be said of the text of an expression without compiling it: length, depth, characters,
/// numbers, brackets and commas. @return the names that are no functions, each once. @throws ExpressionError
[[nodiscard]] std::vector<std::string> names_in_expression(std::string_view text,
                                                           const std::vector<std::string>& functions);

}  // namespace percuss
