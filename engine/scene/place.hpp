#pragma once

namespace percuss {

/// Where a value stands in the scene file (1-based), for messages. See describe_place in parse.hpp.
struct Place {
    int line = 0, column = 0;
    int override_number = 0;  ///< n > 0: given by Scene::overrides[n - 1] instead of the file
    /// Two scenes say the same wherever in their files they say it.
    bool operator==(const Place&) const { return true; }
};

}  // namespace percuss
