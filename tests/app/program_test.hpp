#pragma once

#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/process.hpp"
#include "record/sample_run.hpp"

namespace percuss::test {

/// Two steel blocks that meet at 1 m/s: 3 elements, some 150 steps.
inline const char* const small_scene = R"(percuss = 1
title = "two blocks"
[units]
length = "mm"
time = "ms"
mass = "kg"
[model]
geometry = "plane strain"
duration = 0.02
step.courant = 0.9
[[material]]
name = "steel"
density = 7.85e-6
young = 210.0
poisson = 0.3
[[body]]
name = "striker"
material = "steel"
velocity = [0.0, -1.0]
[[body.block]]
corners = [[0, 0], [2, 0], [2, 1], [0, 1]]
divisions = [2, 1]
[[body]]
name = "anvil"
material = "steel"
[[body.block]]
corners = [[0, -1], [2, -1], [2, 0], [0, 0]]
divisions = [1, 1]
[[contact]]
name = "impact"
master = "striker.bottom"
slave = "anvil.top"
[expect]
"steps" = {min = 1}
)";

/// Each test has a folder of its own with scene.toml in it, in which the program runs.
class ProgramTest : public testing::Test {
  protected:
    ProgramTest() { write("scene.toml", small_scene); }

    void write(const std::string& name, const std::string& text) const { std::ofstream(path(name)) << text; }
    [[nodiscard]] std::filesystem::path path(const std::string& name) const { return folder_.path() / name; }
    [[nodiscard]] bool exists(const std::string& name) const { return std::filesystem::exists(path(name)); }
    [[nodiscard]] Outcome run(std::vector<std::string> arguments) const {
        return percuss(folder_.path(), std::move(arguments));
    }
    [[nodiscard]] nlohmann::json summary(const std::string& directory) const {
        return nlohmann::json::parse(text_of(path(directory) / "summary.json"));
    }
    [[nodiscard]] std::vector<std::string> files(const std::string& directory) const {
        std::vector<std::string> names;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(path(directory))) {
            if (entry.is_regular_file())
                names.push_back(entry.path().lexically_relative(path(directory)).string());
        }
        std::sort(names.begin(), names.end());
        return names;
    }

    TemporaryFolder folder_;
};

}  // namespace percuss::test
