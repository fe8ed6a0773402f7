#include <fmt/format.h>

#include "scene/readers.hpp"

namespace percuss {
namespace {

using Names = std::array<std::string, 2>;

Names coordinate_names(Geometry geometry) {
    return geometry == Geometry::axisymmetric ? Names{"r", "z"} : Names{"x", "y"};
}

/// Formulas under the names of the coordinates. @param variables of the formula of one coordinate
template <class Variables>
CoordinateFormulas read_formulas(TableReader& reader, const Names& names, const Variables& variables) {
    CoordinateFormulas formulas;
    formulas.names = names;
    for (std::size_t i = 0; i < 2; ++i) formulas.by[i] = reader.formula(names[i], variables(i));
    return formulas;
}

FormulaSide read_formula_side(TableReader& reader, const Names& names) {
    const bool both = reader.find(names[0]) && reader.find(names[1]);
    return {read_formulas(
        reader, names, [&](std::size_t i) { return std::vector<std::string>{both ? "s" : names[1 - i]}; })};
}

EdgeShape read_curved_side(TableReader& edges, std::string_view side, const Names& names) {
    auto reader = edges.table(side);
    if (!reader) return Straight{};
    EdgeShape shape = Straight{};
    if (const auto through = reader->numbers("arc", 2)) shape = Arc{vec2(*through)};
    if (const auto points = reader->rows("polyline", 2)) {
        Polyline line;
        for (const auto& point : *points) line.points.push_back(vec2(point));
        shape = std::move(line);
    }
    const bool formula = reader->find(names[0]) || reader->find(names[1]);
    if (formula) shape = read_formula_side(*reader, names);
    const std::size_t kinds =
        (reader->find("arc") ? 1 : 0) + (reader->find("polyline") ? 1 : 0) + (formula ? 1 : 0);
    if (kinds != 1)
        reader->error(
            fmt::format("'{}' must have one of arc, polyline and formulas of {} and {}; write e.g. "
                        "{} = {{arc = [1, 2]}}",
                        side, names[0], names[1], side));
    reader->finish();
    return shape;
}

EdgeShape read_side(TableReader& edges, std::string_view side, const Names& names) {
    const auto* node = edges.find(side);
    if (!node) return Straight{};
    if (!node->is_string()) return read_curved_side(edges, side, names);
    // choice() reports any other word.
    static_cast<void>(edges.choice<int>(side, "shape of a side", {{"straight", 0}}));
    return Straight{};
}

}  // namespace

void read_shape(TableReader& reader, Geometry geometry, Block& block) {
    const auto names = coordinate_names(geometry);
    if (auto edges = reader.table("edges")) {
        for (std::size_t side = 0; side < 4; ++side)
            block.shapes[side] = read_side(*edges, side_names[side], names);
        edges->finish();
    }
    if (auto shift = reader.table("shift")) {
        const std::vector<std::string> variables{
            names[0], names[1], "i", "j", names[0] == "r" ? "R" : "X", names[0] == "r" ? "Z" : "Y"};
        block.shift = read_formulas(*shift, names, [&](std::size_t) { return variables; });
        if (!shift->find(names[0]) && !shift->find(names[1]))
            shift->error(fmt::format("'shift' moves nothing; write {} = \"= FORMULA\"", names[1]));
        shift->finish();
    }
}

}  // namespace percuss
