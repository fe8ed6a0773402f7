#include <fmt/format.h>

#include "mesh/curve.hpp"
#include "mesh/spacing.hpp"
#include "scene/readers.hpp"

namespace percuss {
namespace {

Spacing read_spacing(TableReader& reader) {
    Spacing spacing;
    spacing.length = reader.number("length", positive);
    const auto first = reader.number("first", positive), last = reader.number("last", positive);
    spacing.from_end = reader.find("last") != nullptr;
    spacing.first = first.value_or(last.value_or(0));
    spacing.ratio = reader.number("ratio", {.low = 1, .high = 10}).value_or(1);
    if (const auto largest = reader.number("largest", positive)) spacing.largest = *largest;
    spacing.sizes = reader.list("sizes", positive).value_or(std::vector<double>{});
    const int kinds =
        (reader.find("first") ? 1 : 0) + (reader.find("last") ? 1 : 0) + (reader.find("sizes") ? 1 : 0);
    if (kinds != 1)
        reader.error(reader.title() +
                     " must have one of first, last and sizes; write e.g. {first = 0.5, "
                     "ratio = 1.1, largest = 2}");
    if (reader.find("sizes") && (reader.find("ratio") || reader.find("largest")))
        reader.error("sizes", "'sizes' excludes 'ratio' and 'largest'; leave them out");
    if (spacing.first > spacing.largest)
        reader.error("largest",
                     fmt::format("'largest' is {}, below the first size {}", spacing.largest, spacing.first));
    reader.finish();
    return spacing;
}

/// Length of the sides along which direction 0 or 1 is measured: bottom and left. Nothing when they cannot be
/// drawn, which the mesher tells.
std::optional<double> measured_length(const Block& block, std::size_t direction) {
    const auto& c = block.corners;
    try {
        return direction == 0 ? side_length(block.shapes[0], c[0], c[1])
                              : side_length(block.shapes[3], c[3], c[0]);
    } catch (const std::invalid_argument&) {
        return std::nullopt;
    }
}

void read_spacings(TableReader& reader, const toml::node& node, std::size_t direction, Block& block) {
    const auto what = [&](const toml::node& piece, std::size_t index) {
        return &piece == &node ? fmt::format("'divisions[{}]'", direction)
                               : fmt::format("'divisions[{}][{}]'", direction, index);
    };
    std::vector<Spacing> pieces;
    const auto add = [&](const toml::node& piece) {
        if (auto table = reader.table(piece, what(piece, pieces.size())))
            pieces.push_back(read_spacing(*table));
    };
    if (const auto* array = node.as_array())
        for (const auto& piece : *array) add(piece);
    else
        add(node);
    // A faulty piece has told its own fault.
    const auto length = measured_length(block, direction);
    if (reader.faults().any() || !length) return;
    try {
        block.fractions[direction] = spaced_fractions(pieces, *length);
        block.divisions[direction] = static_cast<int>(block.fractions[direction].size()) - 1;
    } catch (const std::invalid_argument& error) {
        reader.faults().error(place_of(node), fmt::format("'divisions[{}]' {}", direction, error.what()));
    }
}

}  // namespace

void read_cells(TableReader& reader, Block& block) {
    const auto* node = reader.need("divisions", "divisions = [cells along bottom, cells along left]");
    if (!node) return;
    const auto* both = node->as_array();
    if (!both || both->size() != 2) {
        reader.error("divisions",
                     fmt::format("'divisions' is {}; it must be an array of 2, each a number of "
                                 "cells or their sizes",
                                 both ? fmt::format("an array of {}", both->size()) : type_name(*node)));
        return;
    }
    const auto grading = reader.numbers("grading", 2, {.low = 1e-6, .high = 1e6});
    if (grading) block.grading = {(*grading)[0], (*grading)[1]};
    for (std::size_t i = 0; i < 2; ++i) {
        const auto& cells = *both->get(i);
        if (cells.is_table() || cells.is_array()) {
            if (block.grading[i] != 1)
                reader.error("grading",
                             fmt::format("'grading[{}]' is {} where 'divisions[{}]' gives the sizes; "
                                         "keep one",
                                         i, block.grading[i], i));
            read_spacings(reader, cells, i, block);
        } else if (const auto count =
                       reader.whole(cells, fmt::format("'divisions[{}]'", i), {.low = 1, .high = 1e6})) {
            block.divisions[i] = static_cast<int>(*count);
        }
    }
}

}  // namespace percuss
