#pragma once

#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace percuss::render {

class RenderError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// RGB picture, 3 bytes a pixel, top row first.
struct Image {
    int width = 0, height = 0;
    std::vector<std::uint8_t> pixels;
};

/// @throws RenderError when the file cannot be written.
void write_png(const Image& image, const std::filesystem::path& file);
/// A file's bytes as text, to stand inside a page: "data:image/png;base64," and this. @throws RenderError
/// when it cannot be read.
[[nodiscard]] std::string base64_of(const std::filesystem::path& file);
[[nodiscard]] Image read_png(const std::filesystem::path& file);

}  // namespace percuss::render
