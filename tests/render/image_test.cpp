#include "image.hpp"

#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

namespace percuss::render {
namespace {

std::filesystem::path scratch(const std::string& name) {
    return std::filesystem::temp_directory_path() / ("percuss-" + std::to_string(getpid()) + "-" + name);
}

TEST(Image, APngComesBackAsItWasWritten) {
    Image image{5, 3, {}};
    for (int i = 0; i < 45; ++i) image.pixels.push_back(static_cast<std::uint8_t>(5 * i));
    const auto file = scratch("image.png");
    write_png(image, file);
    const Image back = read_png(file);
    EXPECT_EQ(back.width, 5);
    EXPECT_EQ(back.height, 3);
    EXPECT_EQ(back.pixels, image.pixels);
    std::filesystem::remove(file);
}

TEST(Image, AnUnwritablePlaceIsNamed) {
    const Image image{1, 1, {1, 2, 3}};
    try {
        write_png(image, "/no/such/folder/image.png");
        FAIL() << "no exception";
    } catch (const RenderError& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("/no/such/folder/image.png: cannot be written"));
    }
}

TEST(Image, AWrongSizeIsRefused) {
    EXPECT_THROW(write_png(Image{2, 2, {1, 2, 3}}, scratch("wrong.png")), RenderError);
}

TEST(Image, WhatIsNoPngIsRefused) {
    const auto file = scratch("text.png");
    std::ofstream(file) << "not a picture";
    EXPECT_THROW(static_cast<void>(read_png(file)), RenderError);
    std::filesystem::remove(file);
    EXPECT_THROW(static_cast<void>(read_png(file)), RenderError);
}

}  // namespace
}  // namespace percuss::render
