#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "run/force_error.hpp"
#include "run/history_columns.hpp"
#include "scene/parse.hpp"
#include "solver.hpp"

namespace percuss::testing {

/// A scene run to its end, with its full history.
struct RecordedRun {
    Solver solver;
    History history;

    explicit RecordedRun(const Scene& scene, int threads = 1)
        : solver(scene, threads), history(history_columns(scene)) {}

    /// One step, recorded. @throws std::runtime_error when the run diverges, which fails the test.
    void step() {
        if (const auto divergence = solver.step()) throw std::runtime_error(divergence->message);
        history.append(solver.history_row());
    }
    void to_end() {
        while (!solver.finished()) step();
    }
    [[nodiscard]] std::vector<double> column(const std::string& name) const { return history.values(name); }
    /// e + work of contact and friction, largest over the run: what neither force nor motion accounts for
    /// [energy].
    [[nodiscard]] double unexplained_energy() const {
        const auto balance = column("energy.balance"), contact = column("energy.contact");
        std::vector<double> friction(balance.size(), 0);
        if (has_friction(solver.setup()->scene)) friction = column("energy.friction");
        double most = 0;
        for (std::size_t n = 0; n < balance.size(); ++n)
            most = std::max(most, std::abs(balance[n] + contact[n] + friction[n]));
        return most;
    }
};

/// Steel in mm, ms, kg: kN, GPa, J, m/s.
inline constexpr double density = 7.85e-6, young = 210;

inline std::string scene_head(const std::string& geometry, double duration, double poisson,
                              const std::string& step = "courant = 0.9",
                              const std::string& material_extra = "") {
    return fmt::format(R"(percuss = 1
[units]
length = "mm"
time = "ms"
mass = "kg"
[model]
geometry = "{}"
duration = {:.17g}
[model.step]
{}
[[material]]
name = "steel"
density = 7.85e-6
young = 210.0
poisson = {:.17g}
{}
)",
                       geometry, duration, step, poisson, material_extra);
}

/// A body of one rectangular block with edges bottom, right, top, left. @param extra keys and tables of the
/// body; keys first.
inline std::string box_body(const std::string& name, std::array<double, 4> box, std::array<int, 2> divisions,
                            const std::string& keys = "", const std::string& tables = "") {
    return fmt::format(R"([[body]]
name = "{}"
material = "steel"
{}
[[body.block]]
corners = [[{:.17g}, {:.17g}], [{:.17g}, {:.17g}], [{:.17g}, {:.17g}], [{:.17g}, {:.17g}]]
divisions = [{}, {}]
{}
)",
                       name, keys, box[0], box[1], box[2], box[1], box[2], box[3], box[0], box[3],
                       divisions[0], divisions[1], tables);
}

inline std::string contact_pair(const std::string& name, const std::string& master,
                                const std::string& slave) {
    return fmt::format("[[contact]]\nname = \"{}\"\nmaster = \"{}\"\nslave = \"{}\"\n", name, master, slave);
}

inline Scene scene_of(const std::string& text, const std::vector<std::string>& overrides = {}) {
    return parse_scene(text, "scene.toml", overrides);
}

inline Scene rods(const std::vector<std::string>& overrides = {}) {
    return load_scene(PERCUSS_SOURCE_DIR "/scenes/rods.toml", overrides);
}

}  // namespace percuss::testing
