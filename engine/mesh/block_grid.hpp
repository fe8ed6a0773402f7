#pragma once

#include <array>
#include <vector>

#include "scene/scene.hpp"

namespace percuss {

/// The nodes of one meshed block: (columns + 1) x (rows + 1) of the grid, column index fastest, then the
/// centres of crossed cells.
struct BlockGrid {
    int columns = 0, rows = 0;  ///< cells along bottom, cells along left
    std::vector<Vec2> nodes;
    std::vector<Cell>
        cells;  ///< block-local node numbers; the cells of one quad stand together, quads row by row

    [[nodiscard]] std::int32_t node(int column, int row) const { return row * (columns + 1) + column; }
    /// Nodes of a side (bottom, right, top, left), walked with the block on the left hand.
    [[nodiscard]] std::vector<std::int32_t> side(std::size_t side) const;
    /// Length of the shortest side of any quad of the grid.
    [[nodiscard]] double smallest_side() const;
};

/// Meshes a block by transfinite interpolation between its sides (Gordon & Hall 1973), cut by `pattern`.
/// @throws std::invalid_argument when a side cannot be drawn; cells are not checked.
[[nodiscard]] BlockGrid mesh_block(const Block& block, CellPattern pattern);

/// What is wrong with the cells of a block, "" when all corners turn left: names the first bad cell by
/// column, row and place, and says what would be right. @param length label of the unit of length
[[nodiscard]] std::string fault_of_cells(const BlockGrid& grid, const std::string& length);

}  // namespace percuss
