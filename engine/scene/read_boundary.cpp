#include <algorithm>

#include <fmt/format.h>

#include "run/fields.hpp"
#include "scene/readers.hpp"

namespace percuss {
namespace {

/// The edge named by `key` "edge", "" for the whole body when it is absent.
std::string read_edge(TableReader& reader, const Body& body) {
    const auto edge = reader.name("edge");
    if (edge) check_edge(reader, "edge", body, *edge);
    return edge.value_or("");
}

std::array<bool, 2> read_fixed(TableReader& reader, Geometry geometry) {
    const auto directions = direction_names(geometry);
    const std::vector<std::string> valid(directions.begin(), directions.end());
    reader.need("fixed", fmt::format("fixed = [\"{}\"]", valid[0]));
    const auto words = reader.texts("fixed");
    std::array<bool, 2> fixed{false, false};
    if (!words) return fixed;
    if (words->empty())
        reader.error("fixed", fmt::format("'fixed' is empty; name {} or {}", valid[0], valid[1]));
    for (const auto& word : *words) {
        const auto found = std::find(valid.begin(), valid.end(), word);
        if (found == valid.end())
            reader.error("fixed", fmt::format("unknown direction '{}'{}", word, suggest_name(word, valid)));
        else
            fixed[static_cast<std::size_t>(found - valid.begin())] = true;
    }
    return fixed;
}

Constraint read_constraint(TableReader& reader, Geometry geometry, const Body& body) {
    Constraint result;
    result.place = reader.place();
    result.edge = read_edge(reader, body);
    result.fixed = read_fixed(reader, geometry);
    if (const auto box = reader.numbers("box", 4)) {
        result.box = {(*box)[0], (*box)[1], (*box)[2], (*box)[3]};
        if ((*box)[0] > (*box)[2] || (*box)[1] > (*box)[3])
            reader.error("box", "'box' is empty; write [min, min, max, max] of the two coordinates");
    }
    return result;
}

PrescribedVelocity read_prescribed(TableReader& reader, Geometry geometry, const Body& body) {
    PrescribedVelocity result;
    result.place = reader.place();
    result.edge = read_edge(reader, body);
    const auto names = direction_names(geometry);
    reader.need("direction", fmt::format("direction = \"{}\"", names[1]));
    result.direction = reader
                           .choice<Direction>("direction", "direction",
                                              {{names[0], Direction::first}, {names[1], Direction::second}})
                           .value_or(Direction::second);
    reader.need("velocity", "velocity = NUMBER or [[time, velocity], ...]");
    result.velocity = reader.time_function("velocity").value_or(TimeFunction{{{0, 0}}});
    result.from = reader.number("from", not_negative).value_or(result.from);
    result.until = reader.number("until", positive).value_or(result.until);
    if (result.until <= result.from)
        reader.error("until", fmt::format("'until' must be later than 'from', which is {}", result.from));
    return result;
}

std::array<std::optional<TimeFunction>, 2> read_traction(TableReader& load) {
    const auto* node = load.find("traction");
    if (!node) return {};
    const auto* array = node->as_array();
    if (!array || array->size() != 2) {
        load.error("traction", "'traction' must be two components, each a number or [[time, value], ...]");
        return {};
    }
    std::array<std::optional<TimeFunction>, 2> components;
    for (std::size_t i = 0; i < 2; ++i)
        components[i] = load.time_function(*array->get(i), fmt::format("traction[{}]", i));
    return components;
}

EdgeLoad read_load(TableReader& reader, const Body& body) {
    EdgeLoad result;
    result.place = reader.place();
    reader.need("edge", "edge = NAME of an edge");
    result.edge = read_edge(reader, body);
    result.pressure = reader.time_function("pressure");
    result.traction = read_traction(reader);
    if (!reader.find("pressure") && !reader.find("traction"))
        reader.error(reader.title() + " has no load; add pressure = NUMBER or traction = [NUMBER, NUMBER]");
    return result;
}

}  // namespace

void read_boundary(TableReader& body, const Scene& scene, Body& result) {
    for (auto& reader : body.tables("constraint")) {
        result.constraints.push_back(read_constraint(reader, scene.geometry, result));
        reader.finish();
    }
    for (auto& reader : body.tables("prescribed")) {
        auto prescribed = read_prescribed(reader, scene.geometry, result);
        reader.finish();
        // A phase that a parameter leaves out costs nothing.
        if (prescribed.from < scene.duration) result.prescribed.push_back(std::move(prescribed));
    }
    for (auto& reader : body.tables("load")) {
        result.loads.push_back(read_load(reader, result));
        reader.finish();
    }
}

}  // namespace percuss
