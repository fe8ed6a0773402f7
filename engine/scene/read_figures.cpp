#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include "run/fields.hpp"
#include "run/history_columns.hpp"
#include "scene/readers.hpp"

namespace percuss {
namespace {

/// @param noun what the name is called in the message
void check_name(TableReader& reader, std::string_view key, std::string_view noun, const std::string& name,
                const std::vector<std::string>& valid) {
    if (std::find(valid.begin(), valid.end(), name) == valid.end())
        reader.error(key, fmt::format("unknown {} '{}'{}", noun, name, suggest_name(name, valid)));
}

/// All columns that the histories of the scene have; empty when a probe is faulty, which is told already.
std::vector<HistoryColumn> columns_of(const Scene& scene) {
    try {
        return history_columns(scene);
    } catch (const std::invalid_argument&) {
        return {};
    }
}

/// Columns must exist and share an axis.
void check_columns(TableReader& reader, const Scene& scene, const std::vector<std::string>& columns) {
    const auto valid = columns_of(scene);
    if (valid.empty()) return;
    const HistoryColumn* first = nullptr;
    for (const auto& name : columns) {
        const auto found =
            std::find_if(valid.begin(), valid.end(), [&](const auto& c) { return c.name == name; });
        if (found == valid.end()) {
            check_name(reader, "columns", "history column", name, names_of(valid));
        } else if (!first) {
            first = &*found;
        } else if (found->quantity != first->quantity) {
            reader.error("columns",
                         fmt::format("'{}' and '{}' have different units; put them into two figures",
                                     first->name, found->name));
        }
    }
}

std::optional<std::array<double, 2>> read_interval(TableReader& reader, std::string_view key) {
    const auto ends = reader.numbers(key, 2);
    if (!ends) return std::nullopt;
    if ((*ends)[0] >= (*ends)[1])
        reader.error(key, fmt::format("'{}' is empty; write [lowest, highest]", key));
    return std::array{(*ends)[0], (*ends)[1]};
}

void read_labels(TableReader& reader, FigureSpec& figure, std::string_view of) {
    const auto labels = reader.texts("labels");
    if (!labels) return;
    figure.labels = *labels;
    if (labels->size() != figure.columns.size())
        reader.error("labels", fmt::format("{} labels for {} {}; give one for each, or leave 'labels' out",
                                           labels->size(), figure.columns.size(), of));
}

void read_colours(TableReader& reader, FigureSpec& figure, const char* map) {
    figure.colour_map = map;
    const auto chosen = reader.text("colour_map");
    if (!chosen) return;
    check_name(reader, "colour_map", "colour map", *chosen, colour_map_names());
    figure.colour_map = *chosen;
}

void read_field(TableReader& reader, const Scene& scene, FigureSpec& figure) {
    const auto field = reader.text("field");
    if (!field) return;
    if (const auto fault = fault_of_field(scene, "field", *field); !fault.empty())
        reader.error("field", fault);
    figure.field = *field;
}

const Body* read_body(TableReader& reader, const Scene& scene, FigureSpec& figure) {
    reader.need("body", "body = NAME of a [[body]]");
    const auto name = reader.text("body");
    if (!name) return nullptr;
    check_name(reader, "body", "body", *name, names_of(scene.bodies));
    figure.body = *name;
    const auto found = std::find_if(scene.bodies.begin(), scene.bodies.end(),
                                    [&](const Body& body) { return body.name == *name; });
    return found == scene.bodies.end() ? nullptr : &*found;
}

std::optional<std::size_t> read_direction(TableReader& reader, std::string_view key, const Scene& scene) {
    const auto directions = direction_names(scene.geometry);
    return reader.choice<std::size_t>(key, "direction", {{directions[0], 0}, {directions[1], 1}});
}

void read_times(TableReader& reader, const Scene& scene, FigureSpec& figure) {
    figure.times = reader.list("times", {.low = 0, .high = scene.duration}).value_or(std::vector<double>{});
}

void read_history(TableReader& reader, const Scene& scene, FigureSpec& figure) {
    reader.need("columns", "columns = [\"energy.kinetic\"]");
    figure.columns = reader.texts("columns").value_or(std::vector<std::string>{});
    check_columns(reader, scene, figure.columns);
    read_labels(reader, figure, "columns");
    figure.value_title = reader.text("axis").value_or("");
    figure.window = reader.number("window", not_negative).value_or(0);
    figure.factor = reader.number("factor", any_number).value_or(1);
    figure.range = read_interval(reader, "range");
    figure.time = read_interval(reader, "time");
}

void read_mesh_figure(TableReader& reader, const Scene& scene, FigureSpec& figure) {
    reader.need("times", "times = [0, 0.1, 0.3]");
    read_times(reader, scene, figure);
    if (const auto window = reader.numbers("window", 4)) {
        figure.region = {(*window)[0], (*window)[1], (*window)[2], (*window)[3]};
        if ((*window)[0] >= (*window)[2] || (*window)[1] >= (*window)[3])
            reader.error("window", "'window' is empty; write [min, min, max, max] of the two coordinates");
    }
    read_field(reader, scene, figure);
    read_colours(reader, figure, "viridis");
    figure.range = read_interval(reader, "range");
}

void read_space_time(TableReader& reader, const Scene& scene, FigureSpec& figure) {
    static_cast<void>(read_body(reader, scene, figure));
    reader.need("field", fmt::format("field = \"{}\"", available_fields(scene).front().name));
    read_field(reader, scene, figure);
    const auto from = reader.numbers("from", 2), to = reader.numbers("to", 2);
    if (from && to) figure.line = {vec2(*from), vec2(*to)};
    if (reader.node().contains("from") != reader.node().contains("to"))
        reader.error(
            "a line has two ends; write both 'from' and 'to', or neither for the body's middle line");
    if (from && to && *from == *to)
        reader.error("to", "the line has no length; 'from' and 'to' are one point");
    figure.interval = reader.number("interval", positive);
    read_colours(reader, figure, "coolwarm");
    figure.range = read_interval(reader, "range");
    figure.time = read_interval(reader, "time");
}

void read_surface_forces(TableReader& reader, const Scene& scene, FigureSpec& figure) {
    const Body* body = read_body(reader, scene, figure);
    reader.need("edge", "edge = NAME of an edge of the body");
    figure.edge = reader.text("edge").value_or("");
    if (body && reader.node().contains("edge")) check_edge(reader, "edge", *body, figure.edge);
    figure.direction = read_direction(reader, "direction", scene).value_or(figure.direction);
    figure.along = read_direction(reader, "along", scene);
    figure.bins = static_cast<int>(reader.whole("bins", {.low = 2, .high = 1000}).value_or(figure.bins));
    figure.interval = reader.number("interval", positive);
    figure.window = reader.number("window", not_negative).value_or(0);
    figure.factor = reader.number("factor", any_number).value_or(1);
    read_times(reader, scene, figure);
    read_colours(reader, figure, "viridis");
    figure.range = read_interval(reader, "range");
    figure.time = read_interval(reader, "time");
}

void read_clamping(TableReader& reader, const Scene& scene, FigureSpec& figure) {
    figure.columns = reader.texts("pairs").value_or(names_of(scene.contacts));
    for (const auto& pair : figure.columns)
        check_name(reader, "pairs", "contact", pair, names_of(scene.contacts));
    read_labels(reader, figure, "pairs");
    figure.direction = read_direction(reader, "direction", scene).value_or(figure.direction);
    figure.window = reader.number("window", not_negative).value_or(0);
    figure.range = read_interval(reader, "range");
    figure.time = read_interval(reader, "time");
}

void read_figure(TableReader& reader, Scene& scene) {
    FigureSpec figure;
    figure.place = reader.place();
    figure.name = read_unique_name(reader, scene.figures, "name = \"velocities\"");
    reader.need("kind", "kind = \"history\"");
    const auto kind = reader.choice<FigureKind>("kind", "kind of figure",
                                                {{"history", FigureKind::history},
                                                 {"mesh", FigureKind::mesh},
                                                 {"space-time", FigureKind::space_time},
                                                 {"surface-forces", FigureKind::surface_forces},
                                                 {"clamping", FigureKind::clamping},
                                                 {"energy", FigureKind::energy}});
    if (!kind) return;  // which keys are right depends on it
    figure.kind = *kind;
    figure.title = reader.text("title").value_or("");
    switch (figure.kind) {
        case FigureKind::history:
            read_history(reader, scene, figure);
            break;
        case FigureKind::mesh:
            read_mesh_figure(reader, scene, figure);
            break;
        case FigureKind::space_time:
            read_space_time(reader, scene, figure);
            break;
        case FigureKind::surface_forces:
            read_surface_forces(reader, scene, figure);
            break;
        case FigureKind::clamping:
            read_clamping(reader, scene, figure);
            break;
        case FigureKind::energy:
            break;
    }
    reader.finish();
    scene.figures.push_back(std::move(figure));
}

void read_pull_out(TableReader& reader, Scene& scene) {
    Analysis::PullOut pull;
    reader.need("body", "body = NAME of a [[body]]");
    pull.body = reader.text("body").value_or("");
    if (reader.node().contains("body")) check_name(reader, "body", "body", pull.body, names_of(scene.bodies));
    reader.need("friction", "friction = 0.3");
    pull.friction = reader.number("friction", not_negative).value_or(0);
    pull.pairs = reader.texts("pairs").value_or(std::vector<std::string>{});
    std::vector<std::string> touching;
    for (const ContactPair& pair : scene.contacts)
        if (pair.master.body == pull.body || pair.slave.body == pull.body) touching.push_back(pair.name);
    for (const auto& pair : pull.pairs)
        check_name(reader, "pairs", fmt::format("contact of '{}'", pull.body), pair, touching);
    reader.finish();
    scene.analysis.pull_out = std::move(pull);
}

}  // namespace

void read_figures(TableReader& root, Scene& scene) {
    for (auto& reader : root.tables("figure")) read_figure(reader, scene);
}

void read_analysis(TableReader& root, Scene& scene) {
    auto reader = root.table("analysis");
    if (!reader) return;
    scene.analysis.residual =
        reader->number("residual", {.low = 0, .high = 1, .low_open = true}).value_or(scene.analysis.residual);
    scene.analysis.window = reader->number("window", not_negative);
    if (auto pull = reader->table("pull_out")) read_pull_out(*pull, scene);
    reader->finish();
}

}  // namespace percuss
