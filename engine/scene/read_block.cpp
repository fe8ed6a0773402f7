#include <algorithm>

#include <fmt/format.h>

#include "scene/readers.hpp"

namespace percuss {
namespace {

/// Of a whole scene: a bound on the memory that a slip of the pen can ask for.
constexpr double most_cells = 5e6;

double cells_of(const Body& body, const Block& block) {
    const double quads = static_cast<double>(block.divisions[0]) * block.divisions[1];
    return quads * (body.pattern == CellPattern::quads ? 1 : body.pattern == CellPattern::diagonal ? 2 : 4);
}

Block read_block(TableReader& reader, Geometry geometry) {
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
    read_shape(reader, geometry, block);
    read_cells(reader, block);
    if (auto names = reader.table("names")) {
        for (std::size_t side = 0; side < 4; ++side)
            block.edge_names[side] = names->name(side_names[side]).value_or("");
        names->finish();
    }
    reader.finish();
    return block;
}

/// The sides of a body of one block are called bottom, right, top, left unless they are named otherwise.
void name_free_sides(Block& block) {
    const auto given = block.edge_names;
    for (std::size_t side = 0; side < 4; ++side) {
        const bool taken = std::find(given.begin(), given.end(), side_names[side]) != given.end();
        if (given[side].empty() && !taken) block.edge_names[side] = side_names[side];
    }
}

}  // namespace

void read_blocks(TableReader& body, Geometry geometry, Body& result, double& cells) {
    body.need("block", "[[body.block]] with corners and divisions");
    auto readers = body.tables("block");
    if (readers.empty() && body.node().contains("block"))
        body.error("block", fmt::format("the mesh of body '{}' is empty; add a [[body.block]]", result.name));
    for (auto& reader : readers) {
        result.blocks.push_back(read_block(reader, geometry));
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
