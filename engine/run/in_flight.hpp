#pragma once

#include <string_view>

namespace percuss {

/// What it takes to change a value of the scene while its run is under way.
enum class ChangeEffect {
    none,       ///< the run does not read it: views, records, promises, what figures look like
    next_step,  ///< it acts from the next step on
    rebuild,    ///< the run begins anew
};

/// @param key as in command::Set and --set, "model.step.courant". What is not known to be harmless rebuilds;
/// whether the key exists is not asked.
[[nodiscard]] ChangeEffect effect_of_change(std::string_view key);

}  // namespace percuss
