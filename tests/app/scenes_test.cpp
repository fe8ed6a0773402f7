#include <algorithm>
#include <cctype>

#include "app/program_test.hpp"

namespace percuss {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> scenes() {
    std::vector<fs::path> found;
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(PERCUSS_SOURCE_DIR) / "scenes")) {
        if (entry.path().extension() == ".toml") found.push_back(entry.path());
    }
    std::sort(found.begin(), found.end());
    return found;
}

std::string test_name(const testing::TestParamInfo<fs::path>& info) {
    std::string name =
        info.param.lexically_relative(fs::path(PERCUSS_SOURCE_DIR) / "scenes").replace_extension();
    std::replace_if(
        name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
    return name;
}

class SceneTest : public testing::TestWithParam<fs::path> {};

TEST_P(SceneTest, KeepsItsPromises) {
    const test::TemporaryFolder folder;
    const test::Outcome outcome =
        test::percuss(folder.path(), {"run", GetParam(), "--out", "out", "--no-render", "--strict"});
    EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
    EXPECT_THAT(outcome.out, testing::HasSubstr("✓ ")) << "the scene promises nothing";
}

INSTANTIATE_TEST_SUITE_P(Scenes, SceneTest, testing::ValuesIn(scenes()), test_name);
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(SceneTest);

}  // namespace
}  // namespace percuss
