#include <sstream>

#include "app/program_test.hpp"
#include "image.hpp"

namespace percuss {
namespace {

using test::Outcome;
using testing::HasSubstr;
using testing::Not;

const std::string lesson = R"(
[lesson]
title = "two blocks"
text = "They meet."
question = "And then?"
control = "model.step.courant"
look_for = "The force."
answer = "They part."
compare = { schemes = ["projection"], steps = [0.9, 0.3] }
)";

class CompareTest : public test::ProgramTest {
  protected:
    /// A number of the table by case and column.
    [[nodiscard]] double cell(const std::string& file, const std::string& label,
                              const std::string& title) const {
        std::istringstream lines(test::text_of(path(file)));
        std::string line;
        std::getline(lines, line);
        const std::vector<std::string> header = cells(line);
        const auto column = std::find(header.begin(), header.end(), title);
        while (std::getline(lines, line)) {
            const std::vector<std::string> row = cells(line);
            if (row[0] != label || column == header.end()) continue;
            return std::stod(row[static_cast<std::size_t>(column - header.begin())]);
        }
        ADD_FAILURE() << "no " << title << " of " << label;
        return 0;
    }
    /// Commas between quotes are of the cell.
    static std::vector<std::string> cells(const std::string& line) {
        std::vector<std::string> found(1);
        bool quoted = false;
        for (const char c : line) {
            if (c == '"')
                quoted = !quoted;
            else if (c == ',' && !quoted)
                found.emplace_back();
            else
                found.back() += c;
        }
        return found;
    }
};

TEST_F(CompareTest, TheReadmeListsTheSchemesAsTheHelpDoes) {
    const std::string help = run({"compare", "--help"}).out;
    const std::string readme = test::text_of(std::filesystem::path(PERCUSS_SOURCE_DIR) / "README.md");
    std::istringstream lines(help.substr(help.find("Schemes:\n")));
    std::string line, listed;
    std::getline(lines, line);
    while (std::getline(lines, line) && !line.empty()) listed += "  " + line + "\n";
    EXPECT_THAT(listed, HasSubstr("    joint  "));
    EXPECT_THAT(readme, HasSubstr("lists the schemes:\n\n" + listed + "\n"));
}

TEST_F(CompareTest, SchemesAndStepsOfOneSceneStandInOneTable) {
    const Outcome outcome = run({"compare", "scene.toml", "--schemes", "projection,joint", "--steps",
                                 "0.3,0.9", "--out", "page.png", "--csv", "table.csv"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const std::string csv = test::text_of(path("table.csv"));
    EXPECT_THAT(csv, HasSubstr("case,state,peak force [kN],error [%],"));
    // The numbers are those of the runs themselves.
    ASSERT_EQ(run({"run", "scene.toml", "--out", "out", "--no-render", "--set", "model.step.courant=0.3",
                   "--set", "contact_solver.scheme=joint"})
                  .status,
              0);
    const auto summary = this->summary("out");
    EXPECT_NEAR(cell("table.csv", "joint, Δt 0.3", "peak force [kN]"),
                summary["contact"]["impact"]["peak_force"].get<double>(), 1e-8);
    EXPECT_NEAR(cell("table.csv", "joint, Δt 0.3", "v striker, y [m/s]"),
                summary["body"]["striker"]["velocity"]["y"].get<double>(), 1e-8);
    EXPECT_EQ(cell("table.csv", "joint, Δt 0.3", "steps"), summary["steps"].get<double>());
    EXPECT_GT(cell("table.csv", "projection, Δt 0.9", "error [%]"), 0.1);
    EXPECT_THAT(csv, HasSubstr("\"projection, Δt 0.3\",finished,"));
    EXPECT_THAT(outcome.out, HasSubstr("against the finest step of the same scheme"));
    EXPECT_GT(render::read_png(path("page.png")).pixels.size(), 1000U);
}

TEST_F(CompareTest, ADivergedCaseIsARowAndTheOthersAreRunAllTheSame) {
    const Outcome outcome = run({"compare", std::string(PERCUSS_SOURCE_DIR) + "/scenes/rods.toml",
                                 "--schemes", "lagged,projection", "--steps", "0.9", "--out", "out"});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_THAT(outcome.out, HasSubstr("lagged, Δt 0.9: diverged at "));
    const std::string csv = test::text_of(path("out/compare.csv"));
    EXPECT_THAT(csv, HasSubstr("\"lagged, Δt 0.9\",diverged at "));
    EXPECT_THAT(csv, HasSubstr("\"projection, Δt 0.9\",finished,"));
    EXPECT_LT(cell("out/compare.csv", "projection, Δt 0.9", "error [%]"), 4);
    EXPECT_THAT(files("out"), testing::UnorderedElementsAre("compare.png", "compare.csv"));
}

TEST_F(CompareTest, ALessonNamesItsOwnCases) {
    write("scene.toml", test::small_scene + lesson);
    const Outcome outcome = run({"compare", "scene.toml", "--out", "out"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_GT(cell("out/compare.csv", "Δt 0.3", "steps"), 2 * cell("out/compare.csv", "Δt 0.9", "steps"));
    EXPECT_THAT(outcome.out, Not(HasSubstr("joint")));
    const Outcome info = run({"info", "scene.toml"});
    EXPECT_THAT(info.out, HasSubstr("Lesson: two blocks"));
    EXPECT_THAT(info.out, HasSubstr("They part."));
}

TEST_F(CompareTest, WithoutALessonEverySchemeIsRunThatTheSceneCanTake) {
    const Outcome outcome = run({"compare", "scene.toml", "--out", "page.png"});
    EXPECT_THAT(outcome.out, HasSubstr("\nlagged"));
    EXPECT_THAT(outcome.out, HasSubstr("\njoint"));
    const Outcome friction = run({"compare", "scene.toml", "--out", "other.png", "--set",
                                  "contact_solver.scheme=joint", "--set", "contact.impact.friction=0.2"});
    ASSERT_EQ(friction.status, 0) << friction.err;
    EXPECT_THAT(friction.out, Not(HasSubstr("projection")));
    const Outcome refused =
        run({"compare", "scene.toml", "--schemes", "projection", "--out", "third.png", "--set",
             "contact_solver.scheme=joint", "--set", "contact.impact.friction=0.2"});
    EXPECT_EQ(refused.status, 2);
    EXPECT_THAT(refused.err, HasSubstr("cannot take the scheme 'projection'"));
}

TEST_F(CompareTest, ToldWhatIsWrong) {
    const auto complaint = [&](std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), "compare");
        arguments.insert(arguments.end(), {"--out", "page.png"});
        const Outcome outcome = run(arguments);
        EXPECT_EQ(outcome.status, 2) << outcome.out;
        return outcome.err;
    };
    EXPECT_THAT(complaint({"scene.toml", "--schemes", "projektion"}),
                HasSubstr("unknown scheme 'projektion'; did you mean 'projection'?"));
    EXPECT_THAT(complaint({"scene.toml", "--steps", "1.5"}), HasSubstr("no fraction of the critical step"));
    EXPECT_THAT(complaint({"scene.toml", "other"}), HasSubstr("scene.toml is a scene"));
    EXPECT_THAT(complaint({"run"}), HasSubstr("name a second run"));
    EXPECT_THAT(complaint({"one", "two", "--schemes", "joint"}), HasSubstr("--schemes is for a scene"));
    EXPECT_THAT(complaint({"scene.toml", "--vary", "parameters.x"}), HasSubstr("write KEY=VALUE,VALUE"));
    EXPECT_FALSE(exists("page.png"));
}

TEST_F(CompareTest, HelpListsTheSchemes) {
    const Outcome outcome = run({"compare", "--help"});
    EXPECT_THAT(outcome.out, HasSubstr("  lagged "));
    EXPECT_THAT(outcome.out, HasSubstr("  joint "));
}

}  // namespace
}  // namespace percuss
