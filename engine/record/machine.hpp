#pragma once

#include <string>

namespace percuss {

/// Where a run was made: what its timings mean depends on it.
struct Machine {
    std::string cpu;       ///< model name, "unknown" where the system does not tell
    int cores = 0;         ///< logical processors
    std::string compiler;  ///< name and version of what built this program
    std::string build;     ///< "optimised" or "debug"
};

[[nodiscard]] Machine this_machine();

}  // namespace percuss
