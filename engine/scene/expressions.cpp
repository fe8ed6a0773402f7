#include "scene/expressions.hpp"

#include <toml++/toml.h>

#include "scene/faults.hpp"
#include "scene/overrides.hpp"
#include "scene/parameters.hpp"

namespace percuss {
namespace {

using Found = std::map<std::string, std::string>;

void collect(const toml::node& node, const std::string& key, Found& found) {
    const auto below = [&](std::string_view part) {
        return key.empty() ? std::string(part) : key + "." + std::string(part);
    };
    if (const auto* table = node.as_table()) {
        for (const auto& [name, child] : *table) collect(child, below(name.str()), found);
    } else if (const auto* array = node.as_array()) {
        for (std::size_t i = 0; i < array->size(); ++i) {
            const auto* element = array->get_as<toml::table>(i);
            const auto name = element ? (*element)["name"].value_exact<std::string>() : std::nullopt;
            collect(*array->get(i), below(name.value_or(std::to_string(i))), found);
        }
    } else if (const auto text = node.value_exact<std::string>(); text && Parameters::is_expression(*text)) {
        found[key] = *text;
    }
}

}  // namespace

std::map<std::string, std::string> expressions_in(const Scene& scene) {
    toml::table tree = toml::parse(scene.text, scene.file);
    Faults faults(scene.file, scene.overrides);
    apply_overrides(tree, scene.overrides, faults);
    Found found;
    collect(tree, "", found);
    // A parameter is set by its name, whether it has a table or not.
    Found named;
    for (auto& [key, text] : found) {
        const bool value = key.starts_with("parameters.") && key.ends_with(".value");
        named[value ? key.substr(0, key.rfind('.')) : key] = std::move(text);
    }
    return named;
}

}  // namespace percuss
