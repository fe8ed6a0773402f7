#include <fmt/format.h>

#include "commands.hpp"
#include "options.hpp"
#include "run/engine.hpp"

namespace percuss::app {

void add_check(CLI::App& app, Job& job) {
    auto options = std::make_shared<SceneOptions>();
    CLI::App& command =
        *app.add_subcommand("check", "Say whether a scene is sound: its faults, or OK and its size");
    add_scene_options(command, *options);
    command.callback([&job, options] {
        job = [options] {
            // Building the engine meshes the scene and holds the step against the critical one.
            Engine engine(load(*options));
            const auto snapshot = engine.snapshot();
            const Mesh& mesh = snapshot->setup->mesh;
            fmt::print("{}: OK, {} bodies, {} elements, {} nodes, {} contacts\n", options->file,
                       mesh.bodies.size(), mesh.cell_count(), mesh.node_count(),
                       snapshot->setup->scene.contacts.size());
            return 0;
        };
    });
}

}  // namespace percuss::app
