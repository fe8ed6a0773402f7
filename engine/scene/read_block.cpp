#include <algorithm>

#include <fmt/format.h>

#include "scene/readers.hpp"

namespace percuss {
namespace {

constexpr std::array<std::string_view, 4> sides{"bottom", "right", "top", "left"};
/// Of a whole scene: a bound on the memory that a slip of the pen can ask for.
constexpr double most_cells = 5e6;

double cells_of(const Body& body, const Block& block) {
    const double quads = static_cast<double>(block.divisions[0]) * block.divisions[1];
    return quads * (body.pattern == CellPattern::quads ? 1 : body.pattern == CellPattern::diagonal ? 2 : 4);
}

EdgeShape read_curved_side(TableReader& edges, std::string_view side) {
    auto reader = edges.table(side);
    if (!reader) return Straight{};
    EdgeShape shape = Straight{};
    if (const auto through = reader->numbers("arc", 2)) shape = Arc{vec2(*through)};
    if (const auto points = reader->rows("polyline", 2)) {
        Polyline line;
        for (const auto& point : *points) line.points.push_back(vec2(point));
        shape = std::move(line);
    }
    const std::size_t kinds = (reader->find("arc") ? 1 : 0) + (reader->find("polyline") ? 1 : 0);
    if (kinds != 1)
        reader->error(fmt::format("'{}' must have one of arc and polyline; write e.g. {} = {{arc = [1, 2]}}",
                                  side, side));
    reader->finish();
    return shape;
}

EdgeShape read_side(TableReader& edges, std::string_view side) {
    const auto* node = edges.find(side);
    if (!node) return Straight{};
    if (!node->is_string()) return read_curved_side(edges, side);
    // choice() reports any other word.
    static_cast<void>(edges.choice<int>(side, "shape of a side", {{"straight", 0}}));
    return Straight{};
}

void read_divisions(TableReader& reader, Block& block) {
    const auto* node = reader.need("divisions", "divisions = [cells along bottom, cells along left]");
    const auto divisions = reader.numbers("divisions", 2, {.low = 1, .high = 1e6});
    if (!divisions) return;
    for (std::size_t i = 0; i < 2; ++i) {
        const auto& element = *node->as_array()->get(i);
        if (!element.is_integer())
            reader.faults().error(
                place_of(element),
                fmt::format("'divisions[{}]' is {}; it must be an integer", i, (*divisions)[i]));
        block.divisions[i] = static_cast<int>((*divisions)[i]);
    }
}

Block read_block(TableReader& reader) {
    Block block;
    block.place = reader.place("corners");
    reader.need("corners", "corners = [[x, y], [x, y], [x, y], [x, y]], counter-clockwise");
    if (const auto corners = reader.rows("corners", 2)) {
        if (corners->size() != 4)
            reader.error("corners", fmt::format("'corners' has {} points; it must have 4, counter-clockwise",
                                                corners->size()));
        for (std::size_t i = 0; i < std::min<std::size_t>(4, corners->size()); ++i)
            block.corners[i] = vec2((*corners)[i]);
    }
    read_divisions(reader, block);
    if (const auto grading = reader.numbers("grading", 2, {.low = 1e-6, .high = 1e6}))
        block.grading = {(*grading)[0], (*grading)[1]};
    if (auto edges = reader.table("edges")) {
        for (std::size_t side = 0; side < 4; ++side) block.shapes[side] = read_side(*edges, sides[side]);
        edges->finish();
    }
    if (auto names = reader.table("names")) {
        for (std::size_t side = 0; side < 4; ++side)
            block.edge_names[side] = names->name(sides[side]).value_or("");
        names->finish();
    }
    reader.finish();
    return block;
}

/// The sides of a body of one block are called bottom, right, top, left unless they are named otherwise.
void name_free_sides(Block& block) {
    const auto given = block.edge_names;
    for (std::size_t side = 0; side < 4; ++side) {
        const bool taken = std::find(given.begin(), given.end(), sides[side]) != given.end();
        if (given[side].empty() && !taken) block.edge_names[side] = sides[side];
    }
}

}  // namespace

void read_blocks(TableReader& body, Body& result, double& cells) {
    body.need("block", "[[body.block]] with corners and divisions");
    auto readers = body.tables("block");
    if (readers.empty() && body.node().contains("block"))
        body.error("block", fmt::format("the mesh of body '{}' is empty; add a [[body.block]]", result.name));
    for (auto& reader : readers) {
        result.blocks.push_back(read_block(reader));
        const double before = cells;
        cells += cells_of(result, result.blocks.back());
        if (before <= most_cells && cells > most_cells)
            reader.error("divisions",
                         fmt::format("the divisions make {:.3g} cells up to here; at most {:.3g} are allowed",
                                     cells, most_cells));
    }
    if (result.blocks.size() == 1) name_free_sides(result.blocks.front());
}

}  // namespace percuss
