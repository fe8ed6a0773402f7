#include <chrono>
#include <csignal>
#include <ctime>
#include <fstream>

#include <fmt/format.h>
#include <sched.h>
#include <sys/prctl.h>

#include "exit_status.hpp"
#include "interrupt.hpp"
#include "record/summary.hpp"
#include "scene/parse.hpp"
#include "scheme_cases.hpp"
#include "study/study.hpp"

namespace percuss::app {
namespace {

/// The largest resident set so far [MB]. getrusage would count the parent's as well, which a process that is
/// made by vfork begins with.
double peak_memory() {
    std::ifstream status("/proc/self/status");
    std::string key;
    double kilobytes = 0;
    while (status >> key) {
        if (key == "VmHWM:") status >> kilobytes;
    }
    return kilobytes / 1000;
}

double processor_seconds() {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

void pin(int cpu) {
    cpu_set_t set;
    CPU_ZERO(&set);
    CPU_SET(static_cast<unsigned>(cpu), &set);
    sched_setaffinity(0, sizeof set, &set);  // refused: the spread of the times will tell
}

void keep_histories(CaseResult& result, const History& history, const std::vector<std::string>& columns) {
    for (const std::string& column : columns) result.histories[column] = history.values(column);
    result.histories["time"] = history.values("time");
    for (auto& [name, values] : result.histories) values.resize(history.rows());
}

/// Runs the scene as often as its time calls for. Nothing when interrupted.
std::optional<CaseResult> run_repeatedly(const Scene& scene, const std::vector<std::string>& columns,
                                         int repeat) {
    using Clock = std::chrono::steady_clock;
    constexpr int fewest = 3, most = 20;
    constexpr double enough = 1, too_long = 2;  // seconds
    CaseResult result;
    result.memory_before = peak_memory();
    const Clock::time_point start = Clock::now();
    const double processor_start = processor_seconds();
    const auto elapsed = [&] { return std::chrono::duration<double>(Clock::now() - start).count(); };
    for (int run = 0; run < (repeat > 0 ? repeat : most); ++run) {
        if (repeat == 0 && run > 0 && elapsed() > (run < fewest ? too_long : enough)) break;
        const auto done = run_case({scene, "", "", ""}, 1);
        if (!done) return std::nullopt;
        const double seconds = summary_value(done->run.summary, "wall_seconds.step_total").value_or(0);
        if (result.seconds.empty() || seconds < result.best_seconds()) result.summary = done->run.summary;
        result.seconds.push_back(seconds);
        result.state = done->diverged ? CaseState::diverged : CaseState::finished;
        if (done->diverged) {
            result.message = done->run.summary["message"].get<std::string>();
            break;
        }
        if (run == 0) keep_histories(result, *done->run.history, columns);
    }
    result.core_share = (processor_seconds() - processor_start) / elapsed();
    result.memory = peak_memory();
    return result;
}

}  // namespace

int run_planned_case(const StudyFolder& folder, const std::string& key, int cpu) {
    prctl(PR_SET_PDEATHSIG, SIGTERM);  // a killed study leaves no cases behind
    if (cpu >= 0) pin(cpu);
    std::ifstream in(folder.plan());
    const auto plan = nlohmann::ordered_json::parse(in);
    const auto& of = plan.at("cases").at(key);
    CaseResult result;
    try {
        Scene scene = parse_scene(plan.at("text").get<std::string>(), plan.at("file").get<std::string>(),
                                  of.at("overrides").get<std::vector<std::string>>());
        scene.figures.clear();  // what is sampled for them would be timed
        const auto done = run_repeatedly(scene, plan.at("columns").get<std::vector<std::string>>(),
                                         plan.at("repeat").get<int>());
        if (!done) return exit_status::interrupted;
        result = *done;
    } catch (const SceneError& error) {
        result.state = CaseState::refused;
        result.message = error.what();
    }
    write_case_result(result, folder.result(key));
    return exit_status::ok;
}

}  // namespace percuss::app
