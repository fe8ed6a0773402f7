#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "scene/scene.hpp"

namespace percuss {

/// What would hurt the TOML parser (toml++ 3.3): more than 8 MB of text; a key of more than 64 dots, along
/// which it recurses without a bound; a character beyond ASCII outside quotes, which no TOML allows and which
/// can lead its tables of white space astray. @return place and message of the first fault.
[[nodiscard]] std::optional<std::pair<Place, std::string>> fault_of_input(std::string_view text);

}  // namespace percuss
