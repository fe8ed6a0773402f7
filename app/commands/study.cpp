#include <cstdio>

#include <fmt/format.h>

#include "commands.hpp"
#include "context/context.hpp"
#include "exit_status.hpp"
#include "image.hpp"
#include "output.hpp"
#include "record/machine.hpp"
#include "report.hpp"
#include "study/executor.hpp"
#include "study/run_cases.hpp"
#include "study/study_page.hpp"
#include "study/study_table.hpp"

namespace percuss::app {
namespace {

namespace fs = std::filesystem;

struct StudyOptions {
    StudyRequest request;
    std::string out, executor = "local";
    std::size_t jobs = 0;
    bool list = false, force = false, again = false;
};

StudyFolder folder_of(const StudyOptions& options) {
    return options.out.empty() ? usual_study_folder(options.request.file) : StudyFolder(options.out);
}

void print_cases(const Study& study, const StudyFolder& folder) {
    for (const StudyCase& each : study.cases)
        fmt::print("{}{}\n", each.label,
                   !each.scene                                 ? "  (cannot be read)"
                   : read_case_result(folder.result(each.key)) ? "  (there already)"
                                                               : "");
    fmt::print("{} cases into {}\n", study.cases.size(), folder.path().string());
}

std::string describe_executor(const StudyOptions& options) {
    if (options.executor == "slurm") return "Run as a Slurm array, a processor for each case";
    std::size_t jobs = places().size();
    if (options.jobs > 0) jobs = std::min(jobs, options.jobs);
    return fmt::format("{} at a time, each pinned to a core of its own",
                       jobs == 1 ? "One process" : fmt::format("{} processes", jobs));
}

void report(const StudyOptions& options, const Study& study, const StudyFolder& folder,
            const std::vector<CaseResult>& results) {
    const Evaluation evaluation = evaluate(study, results);
    print_aligned(study_rows(study, results, evaluation));
    fmt::print("\n");
    print_aligned(cheapest_rows(study, results, evaluation));
    fmt::print("\n");
    for (const std::string& sentence : conclusions(study, results, evaluation)) fmt::print("{}\n", sentence);
    fmt::print("\n");
    const fs::path csv = folder.path() / "study.csv", html = folder.path() / "study.html";
    write_text_file(csv, study_csv(study, results, evaluation));
    const auto figures = study_figures(study, results, evaluation);
    const auto context = render::make_offscreen_context();
    std::vector<fs::path> pictures;
    for (const StudyFigure& figure : figures) {
        pictures.push_back(folder.path() / (figure.name + ".png"));
        const render::Image image = render::draw_page(*context, figure.page);
        write_whole(pictures.back(), [&](const fs::path& aside) { render::write_png(image, aside); });
    }
    const Machine here = this_machine();
    const std::string machine =
        options.executor == "slurm"
            ? "on nodes of Slurm's choice"
            : fmt::format("{}, {} processors; {}, {}", here.cpu, here.cores, here.compiler, here.build);
    std::string command = "percuss study " + options.request.file;
    for (const std::string& text : options.request.overrides) command += " --set " + text;
    for (const std::string& text : options.request.vary) command += " --vary " + text;
    for (const std::string& text : options.request.quantities) command += " --quantity " + text;
    write_text_file(html, study_page(study, results, evaluation, figures, pictures,
                                     {command, describe_executor(options), machine}));
    for (const fs::path& picture : pictures) fmt::print("{}\n", picture.string());
    fmt::print("{}\n{}\n", csv.string(), html.string());
}

int run_study(const StudyOptions& options) {
    const Study study = make_study(options.request);
    for (const std::string& warning : study.scene.warnings) fmt::print(stderr, "{}\n", warning);
    const StudyFolder folder = folder_of(options);
    if (options.list) {
        print_cases(study, folder);
        return exit_status::ok;
    }
    folder.check(options.force);
    const auto results = run_cases(study, folder, {options.executor == "slurm", options.jobs, options.again});
    if (!results) {
        fmt::print(stderr, "percuss: interrupted; the same command goes on with what is missing\n");
        return exit_status::interrupted;
    }
    report(options, study, folder, *results);
    bool all = true;
    for (std::size_t i = 0; i < results->size(); ++i)
        if (const std::string what = trouble((*results)[i]); !what.empty()) {
            all = false;
            fmt::print(stderr, "percuss: {}: {}\n", study.cases[i].label, what);
        }
    return all ? exit_status::ok : exit_status::run_failed;
}

}  // namespace

void add_study(CLI::App& app, Job& job) {
    auto options = std::make_shared<StudyOptions>();
    CLI::App& command =
        *app.add_subcommand("study", "What accuracy costs: one scene over a grid of steps, meshes, methods");
    command.footer(
        "Cases are all combinations of the values of the scene's [study] and of --vary. Each runs in a "
        "process of "
        "its own, pinned\nto a core, several times for its time. The same command goes on where a killed "
        "study "
        "ended; cases of a changed scene\nor program are computed anew. DIR holds study.html (one page that "
        "needs "
        "nothing else), study.csv, figures, and cases/.\n\nErrors are against exact answers where the scene "
        "has "
        "them, else against Richardson's extrapolation from the finest levels,\nwith its uncertainty. A case "
        "that "
        "fails is a row that says so; the exit status is then 1.\n\nExamples:\n"
        "  percuss study scenes/rods.toml\n"
        "  percuss study scenes/rods.toml --vary scheme=projection,joint,symmetric --out out/schemes\n"
        "  percuss study scenes/nail.toml --vary parameters.shank=4.2,4.4 --quantity "
        "body.nail.extent.axial.min\n"
        "  percuss study scenes/nail.toml --vary \"body.*.element=one-point quad,mean-dilatation quad\" "
        "--jobs 1");
    command.add_option("SCENE", options->request.file, "scene file, e.g. scenes/rods.toml")->required();
    command
        .add_option(
            "--vary", options->request.vary,
            "values of a key as in --set, or of 'scheme' (percuss compare --help); body.*.KEY stands for "
            "all bodies; may be repeated; replaces what [study] says of that key")
        ->type_name("KEY=A,B,...")
        ->expected(1)
        ->take_all();
    command
        .add_option(
            "--quantity", options->request.quantities,
            "what is judged: a history column or a number of summary.json, with its exact value if it is "
            "known; may be repeated; replaces those of [study]")
        ->type_name("PATH[=EXACT]")
        ->expected(1)
        ->take_all();
    command
        .add_option("--tolerance", options->request.tolerance,
                    "relative error within which the cheapest case is looked for; default 0.01")
        ->type_name("PART")
        ->check(CLI::PositiveNumber);
    command.add_option("--set", options->request.overrides, "override a value of the scene in all cases")
        ->type_name("KEY=VALUE")
        ->expected(1)
        ->take_all();
    command.add_option("--out", options->out, "directory; default out/NAME-study")->type_name("DIR");
    command.add_option("--jobs", options->jobs, "cases at a time; default: one a core (slurm: as it likes)")
        ->type_name("N")
        ->check(CLI::Range(1, 4096));
    command
        .add_option("--repeat", options->request.repeat,
                    "runs of each case for its time; default 3 to 20, fewer when they take more than 2 s")
        ->type_name("N")
        ->check(CLI::Range(1, 1000));
    command.add_option("--executor", options->executor, "what runs the cases")
        ->type_name("local|slurm")
        ->check(CLI::IsMember({"local", "slurm"}));
    command.add_flag("--list", options->list, "only list the cases");
    command.add_flag("--again", options->again, "run all cases, those that are there too");
    command.add_flag("--force", options->force, "write into a directory that holds something else");
    command.callback([&job, options] { job = [options] { return run_study(*options); }; });
}

void add_study_case(CLI::App& app, Job& job) {
    struct Options {
        std::string folder, key;
        int cpu = -1;
    };
    auto options = std::make_shared<Options>();
    CLI::App& command = *app.add_subcommand("study-case", "one case of a study, as percuss study calls it");
    command.group("");  // not for people: kept out of the help
    command.add_option("DIR", options->folder)->required();
    command.add_option("KEY", options->key)->required();
    command.add_option("--cpu", options->cpu);
    command.callback([&job, options] {
        job = [options] {
            return run_planned_case(StudyFolder(options->folder), options->key, options->cpu);
        };
    });
}

}  // namespace percuss::app
