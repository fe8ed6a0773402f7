#include "mesh/block_grid.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "mesh/curve.hpp"
#include "scene/bound_formula.hpp"

namespace percuss {
namespace {

std::vector<double> reversed_fractions(std::vector<double> fractions) {
    std::reverse(fractions.begin(), fractions.end());
    for (double& fraction : fractions) fraction = 1 - fraction;
    return fractions;
}

/// Points of a side that is walked against the direction in which its grid index counts.
std::vector<Vec2> points_back(const EdgeShape& shape, const Vec2& from, const Vec2& to,
                              const std::vector<double>& fractions) {
    auto points = points_along(shape, from, to, reversed_fractions(fractions));
    std::reverse(points.begin(), points.end());
    return points;
}

std::vector<double> cell_ends(const Block& block, std::size_t direction) {
    if (!block.fractions[direction].empty()) return block.fractions[direction];
    return graded_fractions(block.divisions[direction], block.grading[direction]);
}

void fill_nodes(const Block& block, BlockGrid& grid) {
    const auto& [c0, c1, c2, c3] = block.corners;
    const auto s = cell_ends(block, 0), t = cell_ends(block, 1);
    const auto bottom = points_along(block.shapes[0], c0, c1, s),
               top = points_back(block.shapes[2], c2, c3, s);
    const auto right = points_along(block.shapes[1], c1, c2, t),
               left = points_back(block.shapes[3], c3, c0, t);
    const auto columns = s.size(), rows = t.size();
    grid.nodes.reserve(columns * rows);
    for (std::size_t j = 0; j < rows; ++j) {
        for (std::size_t i = 0; i < columns; ++i) {
            // The formula holds on the sides too, but only up to rounding.
            if (j == 0 || j + 1 == rows) {
                grid.nodes.push_back(j == 0 ? bottom[i] : top[i]);
            } else if (i == 0 || i + 1 == columns) {
                grid.nodes.push_back(i == 0 ? left[j] : right[j]);
            } else {
                const Vec2 between =
                    (1 - t[j]) * bottom[i] + t[j] * top[i] + (1 - s[i]) * left[j] + s[i] * right[j];
                const Vec2 corners =
                    (1 - t[j]) * ((1 - s[i]) * c0 + s[i] * c1) + t[j] * ((1 - s[i]) * c3 + s[i] * c2);
                grid.nodes.push_back(between - corners);
            }
        }
    }
}

/// Adds the formulas of block.shift, all taken at the places before the shift.
void shift_nodes(const Block& block, BlockGrid& grid) {
    const auto& [by, names] = block.shift;
    const auto before = grid.nodes;
    const auto at = [&](int column, int row) {
        return before[static_cast<std::size_t>(grid.node(column, row))];
    };
    const bool ring = names[0] == "r";
    for (std::size_t direction = 0; direction < 2; ++direction) {
        if (!by[direction]) continue;
        BoundFormula formula(*by[direction]);
        for (int j = 0; j <= grid.rows; ++j) {
            formula.set("j", j);
            formula.set(ring ? "R" : "X", at(grid.columns, j).x());
            for (int i = 0; i <= grid.columns; ++i) {
                formula.set("i", i);
                formula.set(ring ? "Z" : "Y", at(i, grid.rows).y());
                formula.set(names[0], at(i, j).x());
                formula.set(names[1], at(i, j).y());
                grid.nodes[static_cast<std::size_t>(grid.node(i, j))][static_cast<Eigen::Index>(direction)] +=
                    formula.value();
            }
        }
    }
}

void fill_cells(CellPattern pattern, BlockGrid& grid) {
    for (int j = 0; j < grid.rows; ++j) {
        for (int i = 0; i < grid.columns; ++i) {
            const auto a = grid.node(i, j), b = grid.node(i + 1, j), c = grid.node(i + 1, j + 1),
                       d = grid.node(i, j + 1);
            if (pattern == CellPattern::quads) {
                grid.cells.push_back({a, b, c, d});
            } else if (pattern == CellPattern::diagonal) {
                grid.cells.insert(grid.cells.end(), {{a, b, c, -1}, {a, c, d, -1}});
            } else {
                const auto& n = grid.nodes;
                const auto at = [&](std::int32_t node) { return n[static_cast<std::size_t>(node)]; };
                const Vec2 centre = (at(a) + at(b) + at(c) + at(d)) / 4;
                const auto m = static_cast<std::int32_t>(n.size());
                grid.nodes.push_back(centre);
                grid.cells.insert(grid.cells.end(),
                                  {{a, b, m, -1}, {b, c, m, -1}, {c, d, m, -1}, {d, a, m, -1}});
            }
        }
    }
}

/// Sine of the smallest left turn at the corners of a cell; negative when a corner turns right, 0 when a
/// side has no length.
double smallest_turn(const BlockGrid& grid, const Cell& cell) {
    const int count = corner_count(cell);
    const auto at = [&](int i) {
        return grid.nodes[static_cast<std::size_t>(cell[static_cast<std::size_t>(i % count)])];
    };
    double smallest = 1;
    for (int i = 0; i < count; ++i) {
        const Vec2 in = at(i + 1) - at(i), out = at(i + 2) - at(i + 1);
        const double lengths = in.norm() * out.norm();
        if (!(lengths > 0)) return 0;
        smallest = std::min(smallest, (in.x() * out.y() - in.y() * out.x()) / lengths);
    }
    return smallest;
}

Vec2 centre_of(const BlockGrid& grid, const Cell& cell) {
    Vec2 sum{0, 0};
    const int count = corner_count(cell);
    for (int i = 0; i < count; ++i)
        sum += grid.nodes[static_cast<std::size_t>(cell[static_cast<std::size_t>(i)])];
    return sum / count;
}

}  // namespace

std::vector<std::int32_t> BlockGrid::side(std::size_t side) const {
    std::vector<std::int32_t> result;
    switch (side) {
        case 0:
            for (int i = 0; i <= columns; ++i) result.push_back(node(i, 0));
            break;
        case 1:
            for (int j = 0; j <= rows; ++j) result.push_back(node(columns, j));
            break;
        case 2:
            for (int i = columns; i >= 0; --i) result.push_back(node(i, rows));
            break;
        default:
            for (int j = rows; j >= 0; --j) result.push_back(node(0, j));
    }
    return result;
}

double BlockGrid::smallest_side() const {
    double smallest = std::numeric_limits<double>::infinity();
    const auto measure = [&](std::int32_t a, std::int32_t b) {
        smallest = std::min(smallest,
                            (nodes[static_cast<std::size_t>(a)] - nodes[static_cast<std::size_t>(b)]).norm());
    };
    for (int j = 0; j <= rows; ++j)
        for (int i = 0; i < columns; ++i) measure(node(i, j), node(i + 1, j));
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i <= columns; ++i) measure(node(i, j), node(i, j + 1));
    return smallest;
}

BlockGrid mesh_block(const Block& block, CellPattern pattern) {
    BlockGrid grid{block.divisions[0], block.divisions[1], {}, {}};
    fill_nodes(block, grid);
    shift_nodes(block, grid);
    fill_cells(pattern, grid);
    return grid;
}

std::string fault_of_cells(const BlockGrid& grid, const std::string& length) {
    // Flatter corners than this have lost their sign to rounding.
    constexpr double flat = 1e-7;
    const std::size_t per_quad =
        grid.cells.size() / (static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows));
    std::size_t bad = 0, first = 0, inverted = 0;
    for (std::size_t i = 0; i < grid.cells.size(); ++i) {
        const double turn = smallest_turn(grid, grid.cells[i]);
        if (turn > flat) continue;
        if (bad++ == 0) first = i;
        if (turn < -flat) ++inverted;
    }
    if (bad == 0) return "";
    if (inverted == grid.cells.size()) return "all cells are inverted; list the corners counter-clockwise";
    const Vec2 at = centre_of(grid, grid.cells[first]);
    const auto quad = first / per_quad, columns = static_cast<std::size_t>(grid.columns);
    return fmt::format(
        "{} of {} cells {} degenerate or inverted, the first in column {}, row {} at ({:.6g}, {:.6g}) {}; "
        "move the corners and sides so that every cell is convex",
        bad, grid.cells.size(), bad == 1 ? "is" : "are", quad % columns + 1, quad / columns + 1, at.x(),
        at.y(), length);
}

}  // namespace percuss
