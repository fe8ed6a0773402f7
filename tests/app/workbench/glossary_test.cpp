#include "workbench/glossary.hpp"

#include <algorithm>
#include <cctype>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "effects.hpp"
#include "run/fields.hpp"
#include "scene/parse.hpp"

namespace percuss::app {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

TEST(Glossary, IsInOrderAndEveryWordHasOneMeaning) {
    std::vector<std::string> words;
    for (const Term& term : glossary()) {
        EXPECT_THAT(term.meaning, testing::EndsWith("."));
        words.push_back(term.words.front());
    }
    const auto small = [](char c) { return std::tolower(static_cast<unsigned char>(c)); };
    EXPECT_TRUE(std::is_sorted(words.begin(), words.end(), [&](const std::string& a, const std::string& b) {
        return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(),
                                            [&](char x, char y) { return small(x) < small(y); });
    }));
    words.clear();
    for (const Term& term : glossary()) words.insert(words.end(), term.words.begin(), term.words.end());
    std::sort(words.begin(), words.end());
    EXPECT_EQ(std::adjacent_find(words.begin(), words.end()), words.end());
}

TEST(Glossary, ExplainsTheTermsOfATextOnce) {
    EXPECT_THAT(explain("Master nodes and slave sides; master again"), StartsWith("master: "));
    EXPECT_THAT(explain("Master nodes and slave sides; master again"), HasSubstr("\nslave: "));
    const std::string twice = explain("master master");
    EXPECT_EQ(twice, "master: " + meaning_of("master node"));
    EXPECT_EQ(explain("no such word: slaves, mastering"), "") << "parts of words are not terms";
    EXPECT_THAT(explain("VON MISES"), StartsWith("von Mises stress: "));
    EXPECT_THAT(explain("plastic strain"), StartsWith("plastic strain: "));
    EXPECT_THAT(explain("plastic strain"), Not(HasSubstr("plastic: ")));
    EXPECT_THROW(static_cast<void>(meaning_of("nonsense")), std::logic_error);
}

/// What the window says without being asked has a tooltip that says what it means.
TEST(Glossary, KnowsTheTermsOfTheWindow) {
    for (const char* term :
         {"master",         "slave",         "penetration", "Courant",    "hourglass",      "mean dilatation",
          "bulk viscosity", "critical step", "joint",       "projection", "contact search", "contact solve",
          "balance e",      "kinetic",       "internal",    "viscous",    "plastic",        "external",
          "chatter",        "reference",     "probe"})
        EXPECT_FALSE(meaning_of(term).empty());
    const std::string plain = R"(percuss = 1
[units]
length = "mm"
time = "ms"
mass = "kg"
[model]
geometry = "axisymmetric"
duration = 1
[[material]]
name = "m"
density = 7.85e-6
young = 210
poisson = 0.3
johnson_cook = { yield = 0.09, hardening = 0.29, exponent = 0.3, heat_capacity = 383 }
[[body]]
name = "b"
material = "m"
[[body.block]]
corners = [[0, 0], [1, 0], [1, 1], [0, 1]]
divisions = [1, 1]
)";
    Scene scene;
    try {
        scene = parse_scene(plain, "plain.toml");
    } catch (const SceneError& error) {
        FAIL() << error.messages().front();
    }
    for (const FieldInfo& field : available_fields(scene)) {
        const bool plain_word = field.title.find("velocity") != std::string::npos || field.title == "speed";
        EXPECT_TRUE(plain_word || !explain(field.title).empty()) << field.title;
    }
}

}  // namespace
}  // namespace percuss::app
