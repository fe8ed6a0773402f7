#include <fmt/format.h>

#include "scene/readers.hpp"

namespace percuss {

void read_materials(TableReader& root, Scene& scene) {
    root.need("material", "[[material]] with name, density, young and poisson");
    for (auto& reader : root.tables("material")) {
        Material material;
        material.place = reader.place();
        material.name = read_unique_name(reader, scene.materials, "name = \"steel\"");
        const auto unit = [&](Quantity quantity) { return scene.units.label(quantity); };
        reader.need("density", fmt::format("density = NUMBER in {}", unit(Quantity::density)));
        const auto density = reader.number("density", positive);
        reader.need("young", fmt::format("young = NUMBER in {}", unit(Quantity::stress)));
        const auto young = reader.number("young", positive);
        reader.need("poisson", "poisson = 0.3");
        material.poisson =
            reader.number("poisson", {.low = -1, .high = 0.5, .low_open = true, .high_open = true})
                .value_or(0);
        if (auto viscosity = reader.table("viscosity")) {
            material.viscosity = BulkViscosity{viscosity->number("linear", not_negative).value_or(0),
                                               viscosity->number("quadratic", not_negative).value_or(0)};
            viscosity->finish();
        }
        material.density = density.value_or(1);
        material.young = young.value_or(1);
        const bool young_is_new =
            reader.place("young").override_number > reader.place("density").override_number;
        if (density && young)
            check_wave_speed(scene.units, material, reader.place(young_is_new ? "young" : "density"),
                             reader.faults());
        read_plasticity(reader, scene, material);
        reader.finish();
        scene.materials.push_back(std::move(material));
    }
}

}  // namespace percuss
