#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/scene/small_scene.hpp"
#include "run/design_values.hpp"
#include "scene/named_schemes.hpp"

namespace percuss::testing {
namespace {

using ::testing::ElementsAre;

const std::string pair = "[[contact]]\nname = \"hit\"\nmaster = \"rod.face\"\nslave = \"hammer.top\"\n",
                  floor_below = "[[wall]]\nname = \"floor\"\npoint = [0, -3]\nnormal = [0, 1]\n";

/// The small scene with `lines` for its pair, and a wall.
std::string with(const std::string& lines) { return changed(small_scene, pair, floor_below + lines); }

std::string all_of(const std::string& more = "") {
    return with("[[contact]]\nname = \"any\"\nbodies = \"all\"\n" + more);
}

std::vector<std::string> names_of_pairs(const Scene& scene) {
    std::vector<std::string> names;
    for (const ContactPair& each : scene.contacts) names.push_back(each.name);
    return names;
}

TEST(ContactOfAll, IsEveryTwoBodiesEveryWallAndEveryBodyWithItself) {
    const Scene scene = parse_scene(all_of("friction = 0.1\n"), "scene.toml");
    EXPECT_EQ(faults_of(all_of()), "");
    EXPECT_THAT(names_of_pairs(scene), ElementsAre("any-hammer-hammer", "any-hammer-rod", "any-hammer-floor",
                                                   "any-rod-rod", "any-rod-floor"));
    for (const ContactPair& each : scene.contacts) {
        EXPECT_TRUE(each.by_bodies);
        EXPECT_EQ(each.scheme, RowScheme::symmetric);
        EXPECT_EQ(each.friction, 0.1);
        EXPECT_EQ(each.table, "any");
        EXPECT_EQ(is_self_contact(each), each.master.body == each.slave.body);
    }
    EXPECT_EQ(scene.contact_solver.scheme, ContactScheme::joint) << "what needs no roles, unasked";
}

TEST(ContactOfAll, LeavesOutWhatOtherTablesName) {
    const Scene scene = parse_scene(all_of(pair), "scene.toml");
    EXPECT_THAT(names_of_pairs(scene),
                ElementsAre("hit", "any-hammer-hammer", "any-hammer-floor", "any-rod-rod", "any-rod-floor"));
}

TEST(ContactOfAll, HasAShortForm) {
    const std::string text = "contact = \"all\"\n" + with("");
    const Scene scene = parse_scene(text, "scene.toml");
    EXPECT_EQ(scene.contacts.size(), 5U);
    EXPECT_EQ(scene.contacts[0].name, "all-hammer-hammer");
    EXPECT_EQ(scene.contacts[0].place.line, 1);
    const Scene rough = parse_scene(text, "scene.toml", {"contact.all.friction=0.3"});
    for (const ContactPair& each : rough.contacts) EXPECT_EQ(each.friction, 0.3);
    EXPECT_EQ(faults_of("contact = \"alle\"\n" + with("")),
              "scene.toml:1:11: 'contact' is 'alle'; write contact = \"all\", or [[contact]] for each pair");
}

TEST(ContactOfAll, IsOneThingToChange) {
    const Scene scene = parse_scene(all_of(), "scene.toml");
    int frictions = 0;
    for (const DesignValue& value : design_values(scene)) frictions += value.key == "contact.any.friction";
    EXPECT_EQ(frictions, 1);
    const auto overrides = scheme_overrides(*find_scheme("symmetric"), scene);
    EXPECT_EQ(std::count(overrides.begin(), overrides.end(), "contact.any.scheme=symmetric"), 1);
    EXPECT_EQ(parse_scene(all_of(), "scene.toml", overrides).contacts.size(), 5U);
}

TEST(ContactOfAll, FaultsAreToldWithTheirCure) {
    EXPECT_EQ(
        faults_of(all_of("master = \"rod\"\n")),
        "scene.toml:40:10: 'bodies' knows no roles; leave 'master' out, or name 'master' and 'slave' instead "
        "of 'bodies'");
    EXPECT_EQ(faults_of(all_of("[contact_solver]\nscheme = \"projection\"\n")),
              "scene.toml:39:10: the scheme \"projection\" needs roles; name 'master' and 'slave', or write "
              "scheme = \"joint\" in [contact_solver]");
    EXPECT_EQ(
        faults_of(all_of("[[contact]]\nname = \"any-rod-rod\"\nbodies = [\"rod\", \"hammer\"]\n")),
        "scene.toml:38:8: the name 'any-rod-rod', of a pair of \"all\", is taken by line 40; give one of the "
        "two another name");
    EXPECT_EQ(faults_of(with("[[contact]]\nname = \"any\"\nbodies = \"every\"\n")),
              "scene.toml:39:10: 'bodies' is 'every'; write bodies = [\"A\", \"B\"], or bodies = \"all\"");
    EXPECT_EQ(
        faults_of(with("[[contact]]\nname = \"fold\"\nbodies = [\"rod\", \"rod\"]\nscheme = "
                       "\"node-to-side\"\n")),
        "scene.toml:40:10: a body, 'rod', is kept out of itself by the scheme \"symmetric\"; leave 'scheme' "
        "out, or name the pairs that it is for");
    EXPECT_THAT(
        faults_of(all_of("scheme = \"segment-to-segment\"\n")),
        ::testing::HasSubstr("scene.toml:40:10: a body, 'hammer', is kept out of itself by the scheme"));
    EXPECT_EQ(faults_of(all_of("scheme = \"symmetric\"\n")), "");
    EXPECT_EQ(faults_of(with("[[contact]]\nname = \"fold\"\nbodies = [\"rod\", \"rod\"]\n")), "");
}

}  // namespace
}  // namespace percuss::testing
