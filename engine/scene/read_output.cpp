#include <algorithm>

#include <fmt/format.h>

#include "run/fields.hpp"
#include "scene/readers.hpp"

namespace percuss {
namespace {

void check_word(TableReader& reader, std::string_view key, std::string_view noun, const std::string& word,
                const std::vector<std::string>& valid) {
    if (std::find(valid.begin(), valid.end(), word) == valid.end())
        reader.error(key, fmt::format("unknown {} '{}'{}", noun, word, suggest_name(word, valid)));
}

void read_colouring(TableReader& reader, const Scene& scene, ViewOptions& view) {
    if (const auto field = reader.text("field")) {
        if (const auto fault = fault_of_field(scene, "field", *field); !fault.empty())
            reader.error("field", fault);
        view.field = *field;
    }
    if (const auto range = reader.numbers("range", 2)) {
        view.range = {(*range)[0], (*range)[1]};
        if ((*range)[0] >= (*range)[1]) reader.error("range", "'range' is empty; write [lowest, highest]");
    }
    if (const auto map = reader.text("colour_map")) {
        check_word(reader, "colour_map", "colour map", *map, colour_map_names());
        view.colour_map = *map;
    }
}

bool is_history_figure(const Scene& scene, const std::string& name) {
    return std::any_of(scene.figures.begin(), scene.figures.end(), [&](const FigureSpec& figure) {
        return figure.kind == FigureKind::history && figure.name == name;
    });
}

void read_arrows(TableReader& reader, ViewOptions& view) {
    view.forces = reader.flag("forces").value_or(view.forces);
    view.velocities = reader.flag("velocities").value_or(view.velocities);
    view.force_scale = reader
                           .choice<ForceScale>("force_scale", "force scale",
                                               {{"automatic", ForceScale::automatic},
                                                {"fixed", ForceScale::fixed},
                                                {"logarithmic", ForceScale::logarithmic}})
                           .value_or(view.force_scale);
    view.force_reference = reader.number("force_reference", positive);
    view.force_cut_off = reader.number("force_cut_off", {.low = 1e-9, .high = 0.5});
    if (view.force_scale == ForceScale::fixed && !reader.find("force_reference"))
        reader.error("force_scale", "a fixed force scale needs its reference; add force_reference = FORCE");
}

void read_camera(TableReader& reader, Geometry geometry, ViewOptions& view) {
    const auto directions = direction_names(geometry);
    view.up = reader
                  .choice<VerticalAxis>(
                      "up", "direction",
                      {{directions[0], VerticalAxis::first}, {directions[1], VerticalAxis::second}})
                  .value_or(view.up);
    if (const auto window = reader.numbers("window", 4)) {
        view.window = {(*window)[0], (*window)[1], (*window)[2], (*window)[3]};
        if ((*window)[0] >= (*window)[2] || (*window)[1] >= (*window)[3])
            reader.error("window", "'window' is empty; write [min, min, max, max] of the two coordinates");
    }
    if (const auto size = reader.numbers("size", 2, {.low = 64, .high = 16'384}))
        view.size = {static_cast<int>((*size)[0]), static_cast<int>((*size)[1])};
}

}  // namespace

void read_recording(TableReader& root, Scene& scene) {
    auto reader = root.table("record");
    if (!reader) return;
    scene.record.history_every =
        static_cast<int>(reader->whole("history_every", {.low = 1, .high = 1e9}).value_or(1));
    scene.record.frames = reader->number("frames", positive);
    reader->finish();
}

void read_view(TableReader& root, Scene& scene) {
    auto reader = root.table("view");
    if (!reader) return;
    auto& view = scene.view;
    read_colouring(*reader, scene, view);
    view.edges = reader->flag("edges").value_or(view.edges);
    view.mirror = reader->flag("mirror").value_or(view.mirror);
    if (scene.geometry != Geometry::axisymmetric && reader->find("mirror"))
        reader->error("mirror", "'mirror' belongs to axisymmetric scenes; leave it out");
    read_arrows(*reader, view);
    read_camera(*reader, scene.geometry, view);
    if (const auto charts = reader->texts("charts")) {
        view.charts = *charts;
        for (const auto& chart : view.charts)
            if (chart != "force" && chart != "velocity" && chart != "energy" &&
                !is_history_figure(scene, chart))
                check_column(*reader, "charts", scene, chart);
    }
    view.frames_per_second = reader->number("frames_per_second", {.low = 0, .high = 240, .low_open = true})
                                 .value_or(view.frames_per_second);
    reader->finish();
}

}  // namespace percuss
