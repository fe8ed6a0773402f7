#include "record/machine.hpp"

#include <fstream>
#include <thread>

namespace percuss {
namespace {

std::string cpu_model() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);) {
        const std::size_t colon = line.find(": ");
        if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
    }
    return "unknown";
}

}  // namespace

Machine this_machine() {
    Machine machine;
    machine.cpu = cpu_model();
    machine.cores = static_cast<int>(std::thread::hardware_concurrency());
#if defined(__clang__)
    machine.compiler = __VERSION__;
#else
    machine.compiler = "GCC " __VERSION__;
#endif
#ifdef NDEBUG
    machine.build = "optimised";
#else
    machine.build = "debug";
#endif
    return machine;
}

}  // namespace percuss
