#pragma once

#include <string>
#include <vector>

#include <toml++/toml.h>

#include "scene/faults.hpp"

namespace percuss {

/// Puts "dotted.path=value" overrides into the tree of a scene, in order. Elements of arrays of tables are
/// named by their `name` or index; a value that is a bare word but no TOML value is a string. Giving
/// model.step.fixed takes model.step.courant away, and the reverse; the last contact_solver.scheme takes away
/// what the tree so far says for other schemes, an element of a body what the body says for others. Reports
/// paths that lead nowhere.
void apply_overrides(toml::table& root, const std::vector<std::string>& overrides, Faults& faults);

}  // namespace percuss
