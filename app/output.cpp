#include "output.hpp"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <stdexcept>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include "exit_status.hpp"

namespace percuss::app {
namespace {

bool is_frame_name(const std::string& name) {
    const std::string digits = name.substr(0, name.find('.'));
    return name.ends_with(".png") && digits.size() == 6 && name.size() == 10 &&
           std::all_of(digits.begin(), digits.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
}

}  // namespace

OutputDirectory::OutputDirectory(std::filesystem::path path, bool force) : path_(std::move(path)) {
    if (!std::filesystem::exists(path_)) return;
    if (!std::filesystem::is_directory(path_)) {
        throw UsageError(fmt::format("--out {}: there is a file of this name", path_.string()));
    }
    if (!force && !std::filesystem::is_empty(path_)) {
        throw UsageError(
            fmt::format("--out {}: the directory is not empty; choose another, or replace the run "
                        "in it with --force",
                        path_.string()));
    }
}

OutputDirectory::~OutputDirectory() {
    std::error_code not_empty;  // then it stays
    if (made_) std::filesystem::remove(path_, not_empty);
}

void OutputDirectory::make() {
    made_ = std::filesystem::create_directories(path_);
    // The summary first: without it the rest no longer looks like a finished run.
    for (const auto& file : {summary_file(), history_file(), run_file()}) std::filesystem::remove(file);
    if (!std::filesystem::is_directory(frames())) return;
    std::vector<std::filesystem::path> old;
    for (const auto& entry : std::filesystem::directory_iterator(frames())) {
        if (is_frame_name(entry.path().filename().string())) old.push_back(entry.path());
    }
    for (const auto& file : old) std::filesystem::remove(file);
}

std::string frame_name(long long index) { return fmt::format("{:06}.png", index); }

void write_whole(const std::filesystem::path& file,
                 const std::function<void(const std::filesystem::path& aside)>& write) {
    std::filesystem::path aside = file;
    aside.replace_filename(fmt::format(".{}.part{}", file.stem().string(), file.extension().string()));
    try {
        write(aside);
        std::filesystem::rename(aside, file);
    } catch (...) {
        std::error_code ignored;
        std::filesystem::remove(aside, ignored);
        throw;
    }
}

void write_text_file(const std::filesystem::path& file, const std::string& text) {
    write_whole(file, [&](const std::filesystem::path& aside) {
        std::ofstream out(aside, std::ios::binary);
        out << text;
        out.close();
        if (!out) throw std::runtime_error(fmt::format("{}: cannot be written", file.string()));
    });
}

}  // namespace percuss::app
