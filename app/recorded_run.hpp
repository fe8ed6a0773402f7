#pragma once

#include <filesystem>
#include <memory>

#include "live/recording.hpp"

namespace percuss::app {

/// Opens run.h5 for the window. Calls for any number of files may come from any threads: HDF5 takes one at a
/// time, and the others wait. @throws RecordError.
[[nodiscard]] std::unique_ptr<RunSource> open_recorded_run(const std::filesystem::path& file);

}  // namespace percuss::app
