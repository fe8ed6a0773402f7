#include "finished_run.hpp"

#include <fmt/format.h>

#include "exit_status.hpp"

namespace percuss::app {

std::filesystem::path run_file_of(const std::string& argument) {
    std::filesystem::path file = argument;
    if (std::filesystem::is_directory(file)) file /= "run.h5";
    if (!std::filesystem::exists(file)) {
        throw UsageError(
            fmt::format("{}: no such run; name the directory that 'percuss run --out' made, or its run.h5",
                        file.string()));
    }
    return file;
}

}  // namespace percuss::app
