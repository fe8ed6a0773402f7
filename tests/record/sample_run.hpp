#pragma once

#include <array>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>

#include <unistd.h>

#include "record/run_file.hpp"
#include "run/fields.hpp"
#include "run/history.hpp"
#include "run/snapshot.hpp"
#include "scene/parse.hpp"

/// A small run that no solver made: numbers that say which frame, node and component they belong to.
namespace percuss::test {

inline const char* const sample_scene_text = R"(percuss = 1
title = "sample of a record, µ and Δ"
[units]
length = "mm"
time = "ms"
mass = "kg"
[model]
geometry = "plane strain"
duration = 1.0
step.courant = 0.9
[[material]]
name = "steel"
density = 7.85e-6
young = 210.0
poisson = 0.3
[[body]]
name = "striker"
material = "steel"
velocity = [0.0, -1.0]
[[body.block]]
corners = [[0, 0], [2, 0], [2, 1], [0, 1]]
divisions = [2, 1]
names = { bottom = "face" }
[[body]]
name = "anvil"
material = "steel"
[[body.block]]
corners = [[0, -1], [1, -1], [1, 0], [0, 0]]
divisions = [1, 1]
names = { top = "top" }
[[contact]]
name = "impact"
master = "striker.face"
slave = "anvil.top"
)";

/// Two quads of 'striker', one triangle of 'anvil'.
inline Mesh sample_mesh() {
    Mesh mesh;
    for (const auto& [x, y] : {std::pair{0., 0.}, {1., 0.}, {2., 0.}, {0., 1.}, {1., 1.}, {2., 1.}}) {
        mesh.nodes.emplace_back(x, y);
    }
    for (const auto& [x, y] : {std::pair{0., -1.}, {1., -1.}, {0., 0.}}) mesh.nodes.emplace_back(x, y);
    mesh.cells = {{0, 1, 4, 3}, {1, 2, 5, 4}, {6, 7, 8, -1}};
    mesh.bodies = {{"striker",
                    ElementKind::quad_mean_dilatation,
                    0,
                    6,
                    0,
                    2,
                    {{"face", {0, 1, 2}, false}},
                    {{"outline", {0, 1, 2, 5, 4, 3}, true}}},
                   {"anvil",
                    ElementKind::triangle_averaged,
                    6,
                    9,
                    2,
                    3,
                    {{"top", {7, 8}, false}},
                    {{"outline", {6, 7, 8}, true}}}};
    return mesh;
}

inline std::shared_ptr<const RunSetup> sample_setup(const std::vector<std::string>& overrides = {}) {
    auto setup = std::make_shared<RunSetup>();
    setup->scene = parse_scene(sample_scene_text, "sample.toml", overrides);
    setup->mesh = sample_mesh();
    return setup;
}

inline Snapshot sample_snapshot(const std::shared_ptr<const RunSetup>& setup, int frame) {
    Snapshot snapshot;
    snapshot.setup = setup;
    snapshot.time = 0.1 * frame;
    snapshot.step = 7LL * frame;
    snapshot.dt = 0.014;
    snapshot.critical_step = 0.016;
    for (int i = 0; i < 2 * setup->mesh.node_count(); ++i) {
        snapshot.position.push_back(frame + 0.01 * i);
        snapshot.velocity.push_back(-frame - 0.01 * i);
    }
    for (int c = 0; c < setup->mesh.cell_count(); ++c) {
        snapshot.stress.push_back({frame + 0.1 * c, 2. * frame, 3. * frame, 0.5 * c});
    }
    if (has_plasticity(setup->scene)) {
        for (int c = 0; c < setup->mesh.cell_count(); ++c) {
            snapshot.plastic_strain.push_back(0.01 * frame + 0.001 * c);
            snapshot.yield_stress.push_back(0.4 + 0.02 * frame + 0.001 * c);
        }
    }
    if (ambient_temperature(setup->scene)) {
        for (int c = 0; c < setup->mesh.cell_count(); ++c)
            snapshot.temperature.push_back(300. + frame + 0.1 * c);
    }
    for (int i = 0; i < frame % 3; ++i) {  // 0, 1, 2, 0, ... contact forces
        snapshot.contact_forces.push_back({i, 0, i == 0, {1. * frame, 2. * i}});
    }
    snapshot.pairs = {{{0.25 * frame, 0.5 * frame}, frame % 3, 1e-3 * frame}};
    snapshot.bodies = {{{0, -1. / (1 + frame)}}, {{0.5, 0.25 * frame}}};
    snapshot.energy = {1, 2, 3, 4, 5, 6. + frame, 0.5 * frame, 0};
    if (has_friction(setup->scene)) snapshot.energy.friction = -0.125 * (1 + frame);
    snapshot.status = RunStatus::running;
    return snapshot;
}

inline std::vector<HistoryColumn> sample_columns() {
    return {{"time", Quantity::time},
            {"contact.impact.y", Quantity::force},
            {"energy.kinetic", Quantity::energy}};
}

inline void append_sample_rows(History& history, int count) {
    for (int i = 0; i < count; ++i) {
        const auto n = static_cast<double>(history.rows());
        const std::array<double, 3> row{0.014 * n, std::sqrt(n), -n / 3};
        history.append(row);
    }
}

/// Waits until a live run.h5 holds `frames` frames. @returns whether it came to that within half a minute.
inline bool wait_for_frames(const std::filesystem::path& file, std::int64_t frames) {
    using namespace std::chrono_literals;
    for (int i = 0; i < 3000; ++i) {
        try {
            if (RunFile(file).frames() >= frames) return true;
        } catch (const RecordError&) {  // not there yet
        }
        std::this_thread::sleep_for(10ms);
    }
    return false;
}

/// A folder of its own for a test; removed at the end.
class TemporaryFolder {
  public:
    TemporaryFolder() {
        std::string name = (std::filesystem::temp_directory_path() / "percuss-test-XXXXXX").string();
        path_ = ::mkdtemp(name.data());
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

}  // namespace percuss::test
