#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

/// The direction of the arrows: app -> render -> engine, and HDF5 in engine/record alone.
namespace percuss {
namespace {

namespace fs = std::filesystem;

std::string lower(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

std::vector<std::string> lines_of(const fs::path& file) {
    std::ifstream in(file);
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);) lines.push_back(lower(line));
    return lines;
}

/// What a target links, through others too, as CMake knew it when the build was configured.
std::vector<std::string> links_of(const std::string& target) {
    return lines_of(fs::path(PERCUSS_BINARY_DIR) / "link_graph" / (target + ".txt"));
}

bool mentions(const std::vector<std::string>& lines, const std::string& word) {
    return std::any_of(lines.begin(), lines.end(),
                       [&](const std::string& line) { return line.find(word) != std::string::npos; });
}

TEST(LinkGraph, EngineLinksNoneOfVtkImguiHdf5) {
    const auto links = links_of("percuss_engine");
    ASSERT_TRUE(mentions(links, "eigen")) << "the list of links was not written";
    for (const char* library :
         {"vtk", "imgui", "hdf5", "glew", "opengl", "osmesa", "percuss_render", "percuss_record"}) {
        EXPECT_FALSE(mentions(links, library)) << library;
    }
}

TEST(LinkGraph, RecordLinksHdf5AndNothingThatDraws) {
    const auto links = links_of("percuss_record");
    EXPECT_TRUE(mentions(links, "hdf5"));
    for (const char* library : {"vtk", "imgui", "glew", "opengl", "percuss_render"}) {
        EXPECT_FALSE(mentions(links, library)) << library;
    }
}

TEST(LinkGraph, WhatTheWindowReadsOfARunNeedsNoWindow) {
    const auto links = links_of("percuss_live");
    EXPECT_TRUE(mentions(links, "percuss_engine"));
    for (const char* library : {"vtk", "imgui", "hdf5", "glew", "opengl", "glfw", "percuss_render"})
        EXPECT_FALSE(mentions(links, library)) << library;
}

TEST(LinkGraph, RenderDoesNotKnowTheRecord) {
    const auto links = links_of("percuss_render");
    if (links.empty()) GTEST_SKIP() << "built without the render layer";
    EXPECT_TRUE(mentions(links, "vtk"));
    EXPECT_TRUE(mentions(links, "percuss_engine"));
    EXPECT_FALSE(mentions(links, "percuss_record"));
}

/// #include lines under a folder, as "file: line"; `except` is left out.
std::vector<std::string> includes_under(const std::string& folder, const std::string& except = "") {
    std::vector<std::string> found;
    const fs::path root = fs::path(PERCUSS_SOURCE_DIR) / folder;
    for (const auto& entry : fs::recursive_directory_iterator(root)) {
        const std::string name = fs::relative(entry.path(), root).string();
        const std::string extension = entry.path().extension().string();
        if ((extension != ".cpp" && extension != ".hpp") || (!except.empty() && name.starts_with(except)))
            continue;
        for (const std::string& line : lines_of(entry.path())) {
            if (line.starts_with("#include")) found.push_back(name + ": " + line);
        }
    }
    return found;
}

void expect_none(const std::vector<std::string>& includes, const std::vector<std::string>& forbidden) {
    ASSERT_GT(includes.size(), 10U) << "no sources were found";
    for (const std::string& line : includes) {
        for (const std::string& word : forbidden) EXPECT_EQ(line.find(word), std::string::npos) << line;
    }
}

TEST(Includes, KeepTheDirectionOfTheArrows) {
    expect_none(includes_under("engine", "record/"),
                {"<hdf5", "<vtk", "<imgui", "<gl/", "\"record/", "\"view/", "\"context/", "\"commands/"});
    expect_none(includes_under("engine/record"),
                {"<vtk", "<imgui", "<gl/", "\"view/", "\"context/", "\"commands/"});
    const auto hdf5 = includes_under("engine/record");
    EXPECT_TRUE(mentions(hdf5, "<hdf5.h>")) << "the scan does not see what it should forbid elsewhere";
    expect_none(includes_under("render"), {"<hdf5", "\"record/", "\"commands/"});
}

}  // namespace
}  // namespace percuss
