#pragma once

#include <filesystem>
#include <string>

namespace percuss::app {

/// DIR or DIR/run.h5 -> the run file. @throws UsageError when there is none.
[[nodiscard]] std::filesystem::path run_file_of(const std::string& argument);

}  // namespace percuss::app
