#include "film.hpp"

#include <cstdio>
#include <cstdlib>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

namespace percuss::render {
namespace {

std::filesystem::path scratch(const std::string& name) {
    return std::filesystem::temp_directory_path() / ("percuss-" + std::to_string(getpid()) + "-" + name);
}

bool has(const char* program) {
    return std::system((std::string("command -v ") + program + " >/dev/null 2>&1").c_str()) == 0;
}

std::string output_of(const std::string& command) {
    std::string text;
    FILE* pipe = popen(command.c_str(), "r");
    if (pipe == nullptr) return text;
    for (int c = 0; (c = std::fgetc(pipe)) != EOF;) text.push_back(static_cast<char>(c));
    pclose(pipe);
    return text;
}

Image plain(int width, int height, std::uint8_t grey) {
    const auto size = 3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    return {width, height, std::vector<std::uint8_t>(size, grey)};
}

TEST(Film, TenPicturesOfOddSizeMakeTenFrames) {
    if (!has("ffmpeg") || !has("ffprobe")) GTEST_SKIP() << "ffmpeg is not installed";
    const auto file = scratch("film with a blank.mp4");
    Film film(file, 101, 75, 25);
    for (int i = 0; i < 10; ++i) film.add(plain(101, 75, static_cast<std::uint8_t>(20 * i)));
    film.finish();
    const std::string probe = output_of(
        "ffprobe -v error -select_streams v:0 -count_frames -show_entries "
        "stream=codec_name,width,height,nb_read_frames -of default=nk=1:nw=1 '" +
        file.string() + "'");
    EXPECT_EQ(probe, "h264\n102\n76\n10\n");
    std::filesystem::remove(file);
}

TEST(Film, AMissingFfmpegIsNamedWithItsPackage) {
    const char* before = std::getenv("PATH");
    const std::string path = before == nullptr ? "" : before;
    setenv("PATH", "/no/such/folder", 1);
    std::string message;
    try {
        Film film(scratch("none.mp4"), 16, 16, 25);
    } catch (const RenderError& error) {
        message = error.what();
    }
    setenv("PATH", path.c_str(), 1);
    EXPECT_EQ(message, "ffmpeg not found; install the package ffmpeg, or leave out --film");
}

TEST(Film, FfmpegsLastWordsAreReportedAndTheProgramLives) {
    if (!has("ffmpeg")) GTEST_SKIP() << "ffmpeg is not installed";
    std::string message;
    try {
        Film film("/no/such/folder/film.mp4", 640, 480, 25);
        for (int i = 0; i < 50; ++i)
            film.add(plain(640, 480, 100));  // a broken pipe must not end the process
        film.finish();
    } catch (const RenderError& error) {
        message = error.what();
    }
    EXPECT_THAT(message, testing::HasSubstr("/no/such/folder/film.mp4: ffmpeg failed: "));
    EXPECT_THAT(message, testing::HasSubstr("No such file or directory"));
}

TEST(Film, APictureOfAnotherSizeIsRefused) {
    if (!has("ffmpeg")) GTEST_SKIP() << "ffmpeg is not installed";
    const auto file = scratch("size.mp4");
    {
        Film film(file, 64, 48, 25);
        EXPECT_THROW(film.add(plain(64, 50, 1)), RenderError);
        film.add(plain(64, 48, 1));
        film.finish();
        EXPECT_THROW(film.add(plain(64, 48, 1)), RenderError);
    }
    std::filesystem::remove(file);
}

}  // namespace
}  // namespace percuss::render
