#include <algorithm>
#include <chrono>
#include <cstring>
#include <fstream>
#include <list>
#include <set>
#include <thread>

#include <fmt/format.h>
#include <sched.h>

#include "exit_status.hpp"
#include "interrupt.hpp"
#include "study/child_process.hpp"
#include "study/executor.hpp"

namespace percuss::app {
namespace {

struct Running {
    std::string key;
    int cpu;
    ChildProcess process;
};

std::string reason(const StudyFolder& folder, const std::string& key, int status) {
    const std::string words = last_words(folder, key);
    const std::string how =
        status > 128 ? fmt::format("ended by signal {} ({})", status - 128, strsignal(status - 128))
                     : fmt::format("ended with exit status {}", status);
    return words.empty() ? how : how + ": " + words;
}

}  // namespace

std::vector<int> places() {
    cpu_set_t set;
    CPU_ZERO(&set);
    std::vector<int> found;
    if (sched_getaffinity(0, sizeof set, &set) != 0) return {-1};
    std::set<std::string> cores;
    for (int cpu = 0; cpu < CPU_SETSIZE; ++cpu) {
        if (!CPU_ISSET(static_cast<unsigned>(cpu), &set)) continue;
        std::ifstream siblings(
            fmt::format("/sys/devices/system/cpu/cpu{}/topology/thread_siblings_list", cpu));
        std::string core;
        if (!std::getline(siblings, core)) core = std::to_string(cpu);
        if (cores.insert(core).second) found.push_back(cpu);
    }
    return found;
}

std::string last_words(const StudyFolder& folder, const std::string& key) {
    std::ifstream log(folder.log(key));
    std::string line, last;
    while (std::getline(log, line))
        if (!line.empty()) last = line;
    return last;
}

bool run_locally(const StudyFolder& folder, const std::vector<std::string>& keys, std::size_t jobs,
                 const Listener& listener) {
    using namespace std::chrono_literals;
    const InterruptGuard guard;
    std::vector<int> free = places();
    if (jobs > 0 && jobs < free.size()) free.resize(jobs);
    const std::string program = own_program().string();
    std::list<Running> running;
    auto next = keys.begin();
    while (next != keys.end() || !running.empty()) {
        if (InterruptGuard::requested()) return false;  // the list ends its processes
        while (next != keys.end() && !free.empty()) {
            const int cpu = free.back();
            free.pop_back();
            running.push_back(
                {*next, cpu,
                 ChildProcess(program,
                              {"study-case", folder.path().string(), *next, "--cpu", std::to_string(cpu)},
                              folder.log(*next))});
            ++next;
        }
        for (auto one = running.begin(); one != running.end();) {
            const auto status = one->process.ended();
            if (!status) {
                ++one;
                continue;
            }
            // Ctrl-C on a terminal reaches the cases, too.
            if (*status == exit_status::interrupted) return false;
            ExecutorNews news{one->key, *status == exit_status::ok ? "" : reason(folder, one->key, *status),
                              0};
            free.push_back(one->cpu);
            one = running.erase(one);
            news.running = running.size();
            listener(news);
        }
        listener({"", "", running.size()});
        std::this_thread::sleep_for(10ms);
    }
    return true;
}

}  // namespace percuss::app
