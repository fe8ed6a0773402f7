#include "scene/parse.hpp"

#include <fstream>
#include <iterator>

#include <fmt/format.h>
#include <toml++/toml.h>

#include "scene/input_limits.hpp"
#include "scene/overrides.hpp"
#include "scene/parameters.hpp"
#include "scene/readers.hpp"

namespace percuss {
namespace {

toml::table parse_toml(std::string_view text, const std::string& name, Faults& faults) {
    if (const auto fault = fault_of_input(text)) faults.error(fault->first, fault->second);
    faults.throw_if_any();
    try {
        return toml::parse(text, name);
    } catch (const toml::parse_error& error) {
        const auto& begin = error.source().begin;
        faults.error({static_cast<int>(begin.line), static_cast<int>(begin.column)},
                     fmt::format("not TOML: {}; see https://toml.io for the notation", error.description()));
        faults.throw_if_any();
        throw;
    }
}

/// contact = "all" is short for one [[contact]] of all bodies. It is parsed from a text in which it stands at
/// the place of the short form, where messages about it then point.
void spell_out_contact(toml::table& tree) {
    const toml::node* contact = tree.get("contact");
    if (!contact || contact->value<std::string_view>() != "all") return;
    const toml::source_region& region = contact->source();
    auto spelt = toml::parse(
        fmt::format("{}{:{}}[{{ name = \"all\", bodies = \"all\" }}]",
                    std::string(region.begin.line - 1, '\n'), "contact =", region.begin.column - 1),
        region.path ? *region.path : std::string());
    tree.insert_or_assign("contact", std::move(*spelt.get("contact")));
}

}  // namespace

Scene parse_scene(std::string_view text, const std::string& name, const std::vector<std::string>& overrides) {
    Faults faults(name, overrides);
    auto tree = parse_toml(text, name, faults);
    spell_out_contact(tree);
    apply_overrides(tree, overrides, faults);
    Scene scene;
    scene.file = name;
    scene.text = text;
    scene.overrides = overrides;
    Parameters parameters(tree["parameters"].as_table(), faults);
    TableReader root(faults, tree, "the scene", "", &parameters);
    if (auto declared = root.table("parameters")) scene.parameters = parameters.all();
    for (const auto read : {read_header, read_model, read_materials, read_bodies, read_walls, read_contacts,
                            read_probes, read_recording, read_figures, read_view, read_analysis,
                            read_promises, read_lesson, read_study, read_accuracy})
        read(root, scene);
    root.finish();
    faults.throw_if_any();
    scene.warnings = faults.warnings();
    return scene;
}

Scene load_scene(const std::filesystem::path& file, const std::vector<std::string>& overrides) {
    std::ifstream stream(file, std::ios::binary);
    std::error_code error;
    if (!stream || !std::filesystem::is_regular_file(file, error))
        throw SceneError({file.string() + ": cannot be read; name a scene file, e.g. scenes/rods.toml"});
    const std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    return parse_scene(text, file.string(), overrides);
}

}  // namespace percuss
