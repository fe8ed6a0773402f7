#include <stdexcept>

#include <fmt/format.h>

#include "scene/readers.hpp"

namespace percuss {
namespace {

constexpr std::int64_t format_version = 1;

void read_units(TableReader& root, Scene& scene) {
    root.need("units", "[units] with length = \"mm\", time = \"ms\", mass = \"kg\"");
    auto reader = root.table("units");
    if (!reader) return;
    const auto word = [&](std::string_view key, const std::string& fallback) {
        reader->need(key, fmt::format("{} = \"{}\"", key, fallback));
        return reader->text(key).value_or(fallback);
    };
    const std::string length = word("length", "mm"), time = word("time", "ms"), mass = word("mass", "kg");
    bool good = true;
    const auto check = [&](std::string_view key, const std::string& l, const std::string& t,
                           const std::string& m) {
        try {
            static_cast<void>(Units(l, t, m));
        } catch (const std::invalid_argument& error) {
            reader->error(key, error.what());
            good = false;
        }
    };
    // One at a time, the others valid: each fault is told at its own key.
    check("length", length, "ms", "kg");
    check("time", "mm", time, "kg");
    check("mass", "mm", "ms", mass);
    if (good) scene.units = Units(length, time, mass);
    reader->finish();
}

void read_step(TableReader& model, Scene& scene) {
    auto reader = model.table("step");
    if (!reader) return;
    scene.step.place = reader->place();
    scene.step.fixed = reader->number("fixed", positive);
    if (scene.step.fixed) scene.step.place = reader->place("fixed");
    const auto courant = reader->number("courant", {.low = 0, .high = 1, .low_open = true});
    if (courant && scene.step.fixed)
        reader->error("courant", "'courant' and 'fixed' exclude each other; keep one");
    if (courant) {
        scene.step.courant = *courant;
        scene.step.place = reader->place("courant");
    }
    reader->finish();
}

}  // namespace

void read_header(TableReader& root, Scene& scene) {
    root.need("percuss",
              fmt::format("percuss = {} as the first line: the version of the format", format_version));
    const auto version = root.whole("percuss", any_number);
    if (version && *version != format_version) {
        root.error("percuss",
                   fmt::format("version {} of the scene format is unknown; this program reads version {}",
                               *version, format_version));
        root.faults().throw_if_any();
    }
    scene.title = root.text("title").value_or("");
    scene.description = root.text("description").value_or("");
    read_units(root, scene);
}

void read_model(TableReader& root, Scene& scene) {
    root.need("model", "[model] with geometry and duration");
    auto reader = root.table("model");
    if (!reader) root.faults().throw_if_any();
    reader->need("geometry", "geometry = \"axisymmetric\"");
    const auto geometry = reader->choice<Geometry>("geometry", "geometry",
                                                   {{"axisymmetric", Geometry::axisymmetric},
                                                    {"plane strain", Geometry::plane_strain},
                                                    {"plane stress", Geometry::plane_stress}});
    // The names of directions and fields hang on the geometry: without it the rest would only raise false
    // alarms.
    if (!geometry) root.faults().throw_if_any();
    scene.geometry = *geometry;
    scene.thickness = reader->number("thickness", positive).value_or(1);
    if (scene.geometry == Geometry::axisymmetric && reader->find("thickness"))
        reader->error("thickness", "'thickness' has no meaning in an axisymmetric scene; leave it out");
    reader->need("duration", fmt::format("duration = TIME in {}", scene.units.time_name()));
    scene.duration = reader->number("duration", positive).value_or(0);
    scene.lagged = reader->flag("lagged").value_or(false);
    scene.energy_growth_limit = reader->number("energy_growth_limit", positive).value_or(0.5);
    read_step(*reader, scene);
    reader->finish();
}

}  // namespace percuss
