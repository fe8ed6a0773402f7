#include "app/program_test.hpp"

namespace percuss {
namespace {

using test::Outcome;
using testing::HasSubstr;
using testing::MatchesRegex;
using testing::StartsWith;

class UsageTest : public test::ProgramTest {};

TEST_F(UsageTest, HelpShowsExamplesAndExitStatus) {
    const Outcome outcome = run({"--help"});
    EXPECT_EQ(outcome.status, 0);
    for (const char* text :
         {"run", "check", "info", "render", "figures", "Examples:", "Exit status:", "summary.json"}) {
        EXPECT_THAT(outcome.out, HasSubstr(text));
    }
    EXPECT_EQ(run({"run", "--help"}).status, 0);
}

TEST_F(UsageTest, VersionIsOneLine) {
    const Outcome outcome = run({"--version"});
    EXPECT_EQ(outcome.status, 0);
    EXPECT_THAT(outcome.out, MatchesRegex("percuss [0-9]+\\.[0-9]+\\.[0-9]+\n"));
}

TEST_F(UsageTest, BadUsageIsStatusTwo) {
    const std::vector<std::vector<std::string>> bad{
        {},
        {"walk"},
        {"run"},
        {"run", "scene.toml"},
        {"run", "scene.toml", "--out", "out", "--frames", "-1"},
        {"run", "scene.toml", "--out", "out", "--threads", "0"},
        {"run", "scene.toml", "--out", "out", "--film", "film.avi"},
        {"run", "scene.toml", "--out", "out", "--film", "film.mp4", "--no-render"},
        {"render", "nowhere"},
        {"figures", "nowhere", "--out", "figure.png"},
        {"figures", "nowhere", "--out", "figure.jpg"},
    };
    for (const auto& arguments : bad) {
        const Outcome outcome = run(arguments);
        EXPECT_EQ(outcome.status, 2) << testing::PrintToString(arguments) << outcome.err;
        EXPECT_FALSE(outcome.err.empty()) << testing::PrintToString(arguments);
        EXPECT_FALSE(exists("out"));
    }
}

TEST_F(UsageTest, CheckSaysOkAndSize) {
    const Outcome outcome = run({"check", "scene.toml"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "scene.toml: OK, 2 bodies, 3 elements, 10 nodes, 1 contacts\n");
}

TEST_F(UsageTest, CheckNamesFileLineAndColumn) {
    std::string text = test::small_scene;
    text.replace(text.find("material = \"steel\""), 18, "material = \"steal\"");
    write("bad.toml", text);
    const Outcome outcome = run({"check", "bad.toml"});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.out, "");
    EXPECT_THAT(outcome.err, StartsWith("bad.toml:18:"));
    EXPECT_THAT(outcome.err, HasSubstr("unknown material 'steal'"));
    EXPECT_THAT(outcome.err, HasSubstr("steel"));
}

TEST_F(UsageTest, CheckHoldsAFixedStepAgainstTheCriticalOne) {
    const Outcome outcome = run({"check", "scene.toml", "--set", "model.step={fixed=1.0}"});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_THAT(outcome.err, HasSubstr("critical"));
}

TEST_F(UsageTest, InfoTellsMassStepAndEffects) {
    const Outcome outcome = run({"info", "scene.toml"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("plane strain"));
    EXPECT_THAT(outcome.out, HasSubstr(" 1.57e-05 kg"));  // 2 mm2 x 1 mm x 7.85e-6 kg/mm3
    EXPECT_THAT(outcome.out, HasSubstr(" 3.14e-05 kg\n"));
    EXPECT_THAT(outcome.out, HasSubstr("critical step"));
    EXPECT_THAT(outcome.out, HasSubstr("steps to come"));
    EXPECT_THAT(outcome.out,
                HasSubstr("contact impact: master nodes of striker.bottom on slave sides of anvil.top"));
}

}  // namespace
}  // namespace percuss
