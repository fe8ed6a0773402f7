#include "scene/edit_text.hpp"

#include <fstream>
#include <iterator>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "run/engine.hpp"
#include "scene/parse.hpp"

namespace percuss {
namespace {

using testing::EndsWith;
using testing::StartsWith;

std::string scene_file(const std::string& name) {
    std::ifstream in(std::string(PERCUSS_SOURCE_DIR) + "/scenes/" + name, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

std::string edited(const std::string& text, const std::vector<std::string>& overrides) {
    return edit_scene_text(text, "s.toml", overrides);
}

/// The text with one part in place of another.
std::string with(std::string text, const std::string& part, const std::string& other) {
    const auto at = text.find(part);
    EXPECT_NE(at, std::string::npos) << part;
    return text.replace(at, part.size(), other);
}

const std::string small = R"(percuss = 1 # first
title = "µ: two blocks" # of steel
[units]
length = "mm"
time = "ms"
mass = "kg"

[parameters]
speed = { value = 1, range = [0, 5], unit = "m/s", description = "of the µ striker" } # fast
plain = 2

# What is computed.
[model]
geometry = "plane strain"
duration = 0.02
step.courant = 0.9 # of the critical step

[[material]]
name = "steel"
density = 7.85e-6
young = 210.0
poisson = 0.3

# It moves.
[[body]]
name = "striker"
material = "steel"
velocity = [0.0, "= -speed"] # down
[[body.block]]
corners = [[0, 0], [2, 0], [2, 1], [0, 1]]
divisions = [2, 1]

# It rests.
[[body]]
name = "anvil"
material = "steel"
[[body.block]]
corners = [[0, -1], [2, -1], [2, 0], [0, 0]]
divisions = [1, 1]

# They meet.
[[contact]]
name = "impact"
master = "striker.bottom"
slave = "anvil.top"
)";

TEST(EditText, NothingSetChangesNothing) { EXPECT_EQ(edited(small, {}), small); }

TEST(EditText, ValuesChangeWhereTheyStand) {
    EXPECT_EQ(edited(small, {"parameters.speed=2.5"}), with(small, "value = 1,", "value = 2.5,"));
    EXPECT_EQ(edited(small, {"parameters.plain=3"}), with(small, "plain = 2", "plain = 3"));
    EXPECT_EQ(edited(small, {"model.step.courant=0.5"}), with(small, "courant = 0.9", "courant = 0.5"));
    EXPECT_EQ(edited(small, {"title=other words"}), with(small, "\"µ: two blocks\"", "\"other words\""));
    EXPECT_EQ(edited(small, {"body.striker.velocity=[1, -2]"}),
              with(small, "[0.0, \"= -speed\"]", "[1, -2]"));
    EXPECT_EQ(edited(small, {"body.striker.velocity.0=0.5"}), with(small, "[0.0, \"=", "[0.5, \"="));
    EXPECT_EQ(edited(small, {"material.steel.young== 100*speed"}), with(small, "210.0", "\"= 100*speed\""));
    EXPECT_EQ(edited(small, {"model.duration=1", "model.duration=0.03"}), with(small, "0.02", "0.03"))
        << "the last one holds";
}

TEST(EditText, OneKeyTakesTheOthersPlace) {
    EXPECT_EQ(edited(small, {"model.step.fixed=1e-5"}), with(small, "courant = 0.9", "fixed = 1e-5"));
}

TEST(EditText, KeysThatAnotherSchemeHasNoUseForGo) {
    const std::string springs = small + "[contact_solver]\nscheme = \"penalty\"\n";
    EXPECT_EQ(edited(springs + "penalty = 0.3 # soft\nstep = \"elements\"", {"contact_solver.scheme=joint"}),
              small + "[contact_solver]\nscheme = \"joint\"\n");
    const auto in_line = [](const std::string& keys) {
        return "contact_solver = { " + keys + " }\n" + small;
    };
    const std::string joint = in_line("scheme = \"joint\"");
    EXPECT_EQ(edited(in_line("scheme = \"penalty\", penalty = 0.3"), {"contact_solver.scheme=joint"}), joint);
    EXPECT_EQ(edited(in_line("penalty = 0.3, scheme = \"penalty\""), {"contact_solver.scheme=joint"}), joint);
}

TEST(EditText, NewKeysGoToTheEndOfTheirTable) {
    EXPECT_EQ(edited(small, {"contact.impact.sign=unrestricted"}), small + "sign = \"unrestricted\"\n");
    EXPECT_EQ(edited(small, {"material.steel.viscosity={linear = 0.06}"}),
              with(small, "poisson = 0.3\n", "poisson = 0.3\nviscosity = {linear = 0.06}\n"));
    EXPECT_EQ(edited(small, {"body.striker.hourglass=0.05"}),
              with(small, "# down\n", "# down\nhourglass = 0.05\n"));
    EXPECT_EQ(edited(small, {"description=short"}),
              with(small, "# of steel\n", "# of steel\ndescription = \"short\"\n"));
}

TEST(EditText, NewTablesGoToTheEnd) {
    EXPECT_EQ(edited(small, {"contact_solver.scheme=joint"}),
              small + "\n[contact_solver]\nscheme = \"joint\"\n");
    EXPECT_EQ(edited(small, {"view.field=velocity.y", "view.edges=false"}),
              small + "\n[view]\nedges = false\nfield = \"velocity.y\"\n");
}

TEST(EditText, LineEndsOfTheTextAreKept) {
    std::string text;
    for (const char c : small) text += c == '\n' ? "\r\n" : std::string(1, c);
    const std::string result = edited(text, {"contact.impact.sign=unrestricted", "parameters.speed=3"});
    EXPECT_THAT(result, EndsWith("slave = \"anvil.top\"\r\nsign = \"unrestricted\"\r\n"));
    EXPECT_THAT(with(result, "value = 3", "value = 1"), StartsWith(text));
    const std::string open_end = small.substr(0, small.size() - 1);
    EXPECT_EQ(edited(open_end, {"contact.impact.sign=unrestricted"}), small + "sign = \"unrestricted\"\n");
}

TEST(EditText, FaultsAreNotWritten) {
    EXPECT_THROW(static_cast<void>(edited(small, {"parameters.sped=2"})), SceneError);
    EXPECT_THROW(static_cast<void>(edited(small, {"material.steel.poisson=0.7"})), SceneError);
    EXPECT_THROW(static_cast<void>(edited("percuss = ", {})), SceneError);
}

/// Every scene says after the edit what it said with the values set, and its run is the same.
TEST(EditText, TheRunIsTheSame) {
    const std::vector<std::pair<std::string, std::vector<std::string>>> cases{
        {"nail.toml",
         {"parameters.shank=4.4", "parameters.washer_bore=4.7", "model.step.courant=0.5",
          "contact_solver.scheme=projection", "material.sheet-steel.plastic.yield=0.35",
          "parameters.mesh=0.5"}},
        {"rods.toml",
         {"model.step.fixed=200e-6", "body.striker.velocity=[0, 20]", "contact.impact.sign=unrestricted"}},
        {"taylor.toml", {"model.step.courant=0.6"}},
        {"sliding_block.toml", {"model.step.courant=0.6"}}};
    for (const auto& [name, overrides] : cases) {
        const std::string text = scene_file(name), result = edited(text, overrides);
        EXPECT_NE(result, text);
        EXPECT_EQ(std::count(result.begin(), result.end(), '#'), std::count(text.begin(), text.end(), '#'))
            << name << ": comments are kept";
        std::string hashes[2];
        for (const bool saved : {false, true}) {
            Engine engine(saved ? parse_scene(result, name) : parse_scene(text, name, overrides));
            engine.post(command::Steps{20});
            engine.wait();
            hashes[saved ? 1 : 0] = engine.statistics().state_hash;
        }
        EXPECT_EQ(hashes[0], hashes[1]) << name;
    }
}

}  // namespace
}  // namespace percuss
