#include "commands/compare.hpp"

#include <filesystem>

#include <fmt/format.h>

#include "commands.hpp"
#include "exit_status.hpp"
#include "scene/named_schemes.hpp"

namespace percuss::app {
namespace {

bool is_scene(const std::string& name) { return std::filesystem::path(name).extension() == ".toml"; }

void refuse(bool given, const char* option, const char* why) {
    if (given) throw UsageError(fmt::format("{} {}", option, why));
}

int compare(const CompareOptions& options) {
    if (is_scene(options.a)) {
        if (!options.b.empty())
            throw UsageError(fmt::format(
                "{} is a scene: it is compared by itself, by its --schemes; two runs are compared by the "
                "directories that 'percuss run --out' made",
                options.a));
        refuse(options.least.has_value(), "--least", "is for two runs");
        return compare_schemes(options);
    }
    if (options.b.empty())
        throw UsageError(fmt::format(
            "{}: name a second run to compare it with, or a scene (SCENE.toml) with --schemes", options.a));
    if (is_scene(options.b))
        throw UsageError(fmt::format("{} is a scene, {} a run; compare two runs, or one scene by --schemes",
                                     options.b, options.a));
    constexpr const char* of_scene = "is for a scene; two runs are as they are";
    refuse(!options.schemes.empty(), "--schemes", of_scene);
    refuse(!options.steps.empty(), "--steps", of_scene);
    refuse(options.vary.has_value(), "--vary", of_scene);
    refuse(!options.overrides.empty(), "--set", of_scene);
    return compare_two_runs(options);
}

std::string help() {
    std::string text =
        "Two runs: meshes, forces, velocities, energies. The table lists parameters and results that differ, "
        "by "
        "their paths in\nsummary.json. Peaks are those of the moving average that the scene's [analysis] "
        "sets.\n\n"
        "A scene: it is run with each scheme, each step and each value; force and energy of all in one "
        "figure, "
        "and a table:\npeak force, its error, final velocities, energy grown and lost, momentum, "
        "penetration, "
        "events, steps, time of stepping.\nErrors are against the scene's [[exact]] answer, else against the "
        "finest step of the same scheme. What is not given\ncomes from the scene's [lesson], else it is "
        "every "
        "scheme that the scene can take, at the scene's own step.\nOne that diverges is a row that says so; "
        "the exit status is then 1.\n\nSchemes:\n";
    for (const NamedScheme& scheme : named_schemes())
        text += fmt::format("  {:<20} {}\n", scheme.name, scheme.explanation);
    return text;
}

}  // namespace

void add_compare(CLI::App& app, Job& job) {
    auto options = std::make_shared<CompareOptions>();
    CLI::App& command = *app.add_subcommand(
        "compare", "Two runs on one page, or one scene by several contact schemes and steps");
    command.footer(help());
    command.add_option("A", options->a, "a scene; or directory of a run, or its run.h5")->required();
    command.add_option("B", options->b, "another run");
    command
        .add_option("--out", options->out,
                    "the page; of a scene also a directory, for compare.png and compare.csv")
        ->type_name("FILE.png|DIR")
        ->required();
    command.add_option("--csv", options->csv, "all numbers of the table")->type_name("FILE.csv");
    command
        .add_option("--least", options->least,
                    "two runs: smallest difference that is listed, in percent; default 0.1")
        ->type_name("PERCENT")
        ->check(CLI::NonNegativeNumber);
    command.add_option("--schemes", options->schemes, "a scene: contact schemes, see below")
        ->type_name("A,B,...")
        ->delimiter(',')
        ->expected(1)
        ->take_all();
    command.add_option("--steps", options->steps, "a scene: steps as fractions of the critical one")
        ->type_name("0.1,0.9,...")
        ->delimiter(',')
        ->expected(1)
        ->take_all();
    command
        .add_option("--vary", options->vary, "a scene: values of one of its parameters, or of any other key")
        ->type_name("KEY=1,2,...");
    command.add_option("--set", options->overrides, "a scene: override a value in all cases")
        ->type_name("KEY=VALUE")
        ->expected(1)
        ->take_all();
    command.add_option("--threads", options->threads, "a scene: threads that step the elements")
        ->type_name("N")
        ->check(CLI::Range(1, 256))
        ->capture_default_str();
    command.add_flag("--force", options->force, "replace existing files");
    command.callback([&job, options] { job = [options] { return compare(*options); }; });
}

}  // namespace percuss::app
