#include <algorithm>

#include <fmt/format.h>

#include "scene/readers.hpp"

namespace percuss {
namespace {

void read_element(TableReader& reader, Body& body) {
    body.element = reader
                       .choice<ElementKind>("element", "element",
                                            {{"one-point quad", ElementKind::quad_one_point},
                                             {"mean-dilatation quad", ElementKind::quad_mean_dilatation},
                                             {"triangle", ElementKind::triangle},
                                             {"averaged triangle", ElementKind::triangle_averaged}})
                       .value_or(ElementKind::quad_one_point);
    const bool triangles = is_triangle(body.element);
    body.pattern = triangles ? CellPattern::diagonal : CellPattern::quads;
    const auto pattern = reader.choice<CellPattern>(
        "pattern", "pattern", {{"diagonal", CellPattern::diagonal}, {"crossed", CellPattern::crossed}});
    if (pattern && !triangles)
        reader.error("pattern",
                     "'pattern' belongs to triangles; leave it out or write element = \"triangle\"");
    else if (pattern)
        body.pattern = *pattern;
    body.hourglass = reader.number("hourglass", {.low = 0, .high = 1}).value_or(0.1);
    if (reader.find("hourglass") && body.element != ElementKind::quad_one_point)
        reader.error(
            "hourglass",
            "'hourglass' belongs to one-point quads; leave it out or write element = \"one-point quad\"");
}

void check_material(TableReader& reader, const Scene& scene, const Body& body) {
    const auto names = names_of(scene.materials);
    if (std::find(names.begin(), names.end(), body.material) == names.end())
        reader.error("material", fmt::format("unknown material '{}'{}", body.material,
                                             suggest_name(body.material, names)));
}

}  // namespace

std::vector<std::string> edge_names(const Body& body) {
    std::vector<std::string> names;
    for (const auto& block : body.blocks)
        for (const auto& name : block.edge_names)
            if (!name.empty() && std::find(names.begin(), names.end(), name) == names.end())
                names.push_back(name);
    for (const auto& chain : body.chains) names.push_back(chain.name);
    return names;
}

void read_chains(TableReader& body, Body& result) {
    auto reader = body.table("chains");
    if (!reader) return;
    const auto edges = edge_names(result);
    std::vector<Chain> chains;
    for (const auto& [key, value] : reader->node()) {
        Chain chain{std::string(key.str()), reader->texts(key.str()).value_or(std::vector<std::string>{})};
        if (!is_name(chain.name))
            reader->error(key.str(), fmt::format("'{}' is not a name; use letters, digits, '_' and '-' only",
                                                 chain.name));
        if (std::find(edges.begin(), edges.end(), chain.name) != edges.end())
            reader->error(key.str(),
                          fmt::format("body '{}' has an edge '{}' already; give the chain a name of "
                                      "its own",
                                      result.name, chain.name));
        if (chain.edges.empty() && value.is_array())
            reader->error(key.str(), fmt::format("'{}' is empty; write {} = [\"left\", \"top\"]", chain.name,
                                                 chain.name));
        for (const auto& edge : chain.edges) check_edge(*reader, key.str(), result, edge);
        chains.push_back(std::move(chain));
    }
    result.chains = std::move(chains);
}

void check_edge(TableReader& reader, std::string_view key, const Body& body, const std::string& edge) {
    const auto names = edge_names(body);
    if (std::find(names.begin(), names.end(), edge) == names.end())
        reader.error(key,
                     fmt::format("body '{}' has no edge '{}'{}", body.name, edge, suggest_name(edge, names)));
}

void read_bodies(TableReader& root, Scene& scene) {
    root.need("body", "[[body]] with name, material and [[body.block]]");
    auto readers = root.tables("body");
    if (readers.empty() && root.node().contains("body"))
        root.error("body", "the mesh is empty; add a [[body]]");
    double cells = 0;
    for (auto& reader : readers) {
        Body body;
        body.place = reader.place();
        body.name = read_unique_name(reader, scene.bodies, "name = \"rod\"");
        reader.need("material", "material = NAME of a [[material]]");
        if (const auto material = reader.name("material")) {
            body.material = *material;
            check_material(reader, scene, body);
        }
        read_element(reader, body);
        const auto pair = [&](std::string_view key) {
            const auto numbers = reader.numbers(key, 2);
            return numbers ? std::array{(*numbers)[0], (*numbers)[1]} : std::array{0.0, 0.0};
        };
        body.velocity = pair("velocity");
        body.body_force = pair("body_force");
        read_blocks(reader, scene.geometry, body, cells);
        read_chains(reader, body);
        read_boundary(reader, scene, body);
        reader.finish();
        scene.bodies.push_back(std::move(body));
    }
}

}  // namespace percuss
