#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.hpp"

namespace percuss {

/// A way to treat contact, under one name: what a scene must say for it.
struct NamedScheme {
    std::string name;
    std::vector<std::string> overrides;  ///< as --set; contact.* stands for each pair of the scene
    std::string explanation;             ///< a line
};

/// All of them, the teaching modes first. The table is in named_schemes.cpp; a line there is all that a
/// scheme needs to be compared, chosen in the window and named by lessons.
[[nodiscard]] const std::vector<NamedScheme>& named_schemes();
[[nodiscard]] std::vector<std::string> scheme_names();
/// Null when there is none of that name.
[[nodiscard]] const NamedScheme* find_scheme(std::string_view name);

/// "body.*.element=triangle" as one override for each body; likewise material.* and contact.*. Any other
/// setting as it is; nothing when the scene has none of the kind.
[[nodiscard]] std::vector<std::string> spell_out(const std::string& setting, const Scene& scene);

/// The scheme's overrides for the pairs of this scene.
[[nodiscard]] std::vector<std::string> scheme_overrides(const NamedScheme& scheme, const Scene& scene);

/// How a scene stands to the table.
struct SchemeChoice {
    std::string name;
    std::string fault;     ///< why the scene cannot be read with it; "" when it can
    bool present = false;  ///< the scene is what it would be with it
    bool goes_on = false;  ///< a run of the scene can go on with it; else it begins anew
};
/// One for each named scheme: the scene's text is read anew with each. @pre the scene was parsed.
[[nodiscard]] std::vector<SchemeChoice> scheme_choices(const Scene& scene);

}  // namespace percuss
