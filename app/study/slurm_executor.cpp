#include <algorithm>
#include <chrono>
#include <fstream>
#include <set>
#include <stdexcept>
#include <thread>

#include <fmt/format.h>

#include "interrupt.hpp"
#include "output.hpp"
#include "study/child_process.hpp"
#include "study/executor.hpp"

namespace percuss::app {
namespace {

/// In single quotes for the shell of the script.
std::string quoted(const std::string& text) {
    std::string result = "'";
    for (const char c : text) result += c == '\'' ? "'\\''" : std::string(1, c);
    return result + "'";
}

/// One task of the array a line of the list. A processor of its own for each task; Slurm pins it.
std::string script(const StudyFolder& folder, const std::filesystem::path& list, std::size_t count,
                   std::size_t jobs) {
    return fmt::format(
        "#!/bin/sh\n"
        "#SBATCH --job-name=percuss-study\n"
        "#SBATCH --array=1-{}{}\n"
        "#SBATCH --ntasks=1\n"
        "#SBATCH --cpus-per-task=1\n"
        "#SBATCH --output=/dev/null\n"
        "key=$(sed -n \"${{SLURM_ARRAY_TASK_ID}}p\" {})\n"
        "exec {} study-case {} \"$key\" >{}/\"$key\".log 2>&1\n",
        count, jobs > 0 ? fmt::format("%{}", jobs) : "", quoted(list.string()),
        quoted(own_program().string()), quoted(folder.path().string()), quoted(folder.cases().string()));
}

std::string first_line(const std::filesystem::path& file) {
    std::ifstream in(file);
    std::string line;
    std::getline(in, line);
    return line;
}

/// "123" or "123;cluster", as sbatch --parsable tells it.
std::string job_number(const std::string& line) {
    const std::string number = line.substr(0, line.find(';'));
    return !number.empty() && number.find_first_not_of("0123456789") == std::string::npos ? number : "";
}

}  // namespace

bool run_by_slurm(const StudyFolder& given, const std::vector<std::string>& keys, std::size_t jobs,
                  const Listener& listener) {
    using namespace std::chrono_literals;
    const InterruptGuard guard;
    const StudyFolder folder(std::filesystem::absolute(given.path()));  // tasks start elsewhere
    const auto list = folder.path() / "slurm-cases.txt", batch = folder.path() / "slurm.sh",
               said = folder.path() / "slurm.log";
    std::string lines;
    for (const std::string& key : keys) lines += key + "\n";
    write_text_file(list, lines);
    write_text_file(batch, script(folder, list, keys.size(), jobs));
    // A result of an earlier try is none of this one.
    for (const std::string& key : keys) std::filesystem::remove(folder.result(key));
    // --wait: sbatch ends with the array, whatever becomes of its tasks.
    ChildProcess sbatch("sbatch", {"--parsable", "--wait", batch.string()}, said);
    std::set<std::string> waiting(keys.begin(), keys.end());
    const auto collect = [&] {
        for (auto key = waiting.begin(); key != waiting.end();) {
            if (!std::filesystem::exists(folder.result(*key))) {
                ++key;
                continue;
            }
            const std::string done = *key;
            key = waiting.erase(key);
            listener({done, "", std::min<std::size_t>(waiting.size(), 1)});
        }
    };
    std::optional<int> status;
    while (!status) {
        status = sbatch.ended();
        if (InterruptGuard::requested()) {
            if (const std::string job = job_number(first_line(said)); !job.empty()) {
                ChildProcess cancel("scancel", {job}, folder.path() / "slurm-cancel.log");
                while (!cancel.ended()) std::this_thread::sleep_for(20ms);
            }
            return false;
        }
        collect();
        listener({"", "", waiting.size()});
        std::this_thread::sleep_for(100ms);
    }
    if (job_number(first_line(said)).empty())
        throw std::runtime_error(fmt::format(
            "sbatch took no job: {}; is Slurm running, and may this account use it?",
            first_line(said).empty() ? fmt::format("exit status {}", *status) : first_line(said)));
    collect();
    for (const std::string& key : waiting) {
        const std::string words = last_words(folder, key);
        listener({key, words.empty() ? "its Slurm task left no result" : words, 0});
    }
    return true;
}

}  // namespace percuss::app
