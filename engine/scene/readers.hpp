#pragma once

#include "scene/scene.hpp"
#include "scene/table_reader.hpp"

/// One reader for each part of a scene file. They fill the scene in this order, each relying on the parts
/// before it, and report faults to the reader's Faults.
namespace percuss {

void read_header(TableReader& root, Scene& scene);     ///< percuss, title, description, [units]
void read_model(TableReader& root, Scene& scene);      ///< [model], [model.step]
void read_materials(TableReader& root, Scene& scene);  ///< [[material]]
void read_bodies(TableReader& root, Scene& scene);     ///< [[body]]
void read_walls(TableReader& root, Scene& scene);      ///< [[wall]]
void read_contacts(TableReader& root, Scene& scene);   ///< [[contact]]
void read_probes(TableReader& root, Scene& scene);     ///< [[probe]]
void read_recording(TableReader& root, Scene& scene);  ///< [record]
void read_figures(TableReader& root, Scene& scene);    ///< [[figure]]
void read_view(TableReader& root, Scene& scene);       ///< [view]
void read_analysis(TableReader& root, Scene& scene);   ///< [analysis]
void read_promises(TableReader& root, Scene& scene);   ///< [[exact]], [expect]
void read_lesson(TableReader& root, Scene& scene);     ///< [lesson]
void read_study(TableReader& root, Scene& scene);      ///< [study]
void read_accuracy(TableReader& root, Scene& scene);   ///< [accuracy], after [study]

// Part of [[material]].
/// @pre name and elastic constants of `material` are read.
void read_plasticity(TableReader& material_table, const Scene& scene, Material& material);

// Parts of [[body]].
/// @param cells count of cells so far, raised by those of this body; an absurd sum is a fault.
void read_blocks(TableReader& body, Geometry geometry, Body& result, double& cells);
/// Shapes of the sides, `edges`, and `shift` of a block.
void read_shape(TableReader& reader, Geometry geometry, Block& block);
/// Cells along the sides, `divisions` and `grading`; needs the shape.
void read_cells(TableReader& reader, Block& block);
void read_chains(TableReader& body, Body& result);                        ///< chains; needs the blocks
void read_boundary(TableReader& body, const Scene& scene, Body& result);  ///< constraint, prescribed, load

/// Warns when the wave speed of a material is absurd in the declared units, and names the likely slip.
void check_wave_speed(const Units& units, const Material& material, const Place& place, Faults& faults);

inline constexpr std::array<std::string_view, 4> side_names{"bottom", "right", "top", "left"};

/// Names of the elements of a list that has names.
template <class List>
[[nodiscard]] std::vector<std::string> names_of(const List& list) {
    std::vector<std::string> names;
    for (const auto& element : list) names.push_back(element.name);
    return names;
}

/// Names of all edges of a body.
[[nodiscard]] std::vector<std::string> edge_names(const Body& body);
/// Reports an edge that the body does not have, at `key`.
void check_edge(TableReader& reader, std::string_view key, const Body& body, const std::string& edge);

/// Reports a history column that names a contact, body or probe which the scene does not have.
void check_column(TableReader& reader, std::string_view key, const Scene& scene, const std::string& column);

/// The new element's name, as written when it is faulty; reports a name that an earlier element of the list
/// has.
template <class List>
[[nodiscard]] std::string read_unique_name(TableReader& reader, const List& list, std::string_view example) {
    reader.need("name", example);
    const auto name = reader.name("name");
    if (!name) return reader.node()["name"].value_or(std::string());
    for (const auto& element : list)
        if (element.name == *name)
            reader.error("name", "the name '" + *name + "' is taken by line " +
                                     std::to_string(element.place.line) + "; give each its own name");
    return *name;
}

[[nodiscard]] inline Vec2 vec2(const std::vector<double>& numbers) { return {numbers[0], numbers[1]}; }

}  // namespace percuss
