#include <fmt/format.h>
#include <gtest/gtest.h>

#include "contact/joint/make_rows.hpp"
#include "engine/scene/small_scene.hpp"

namespace percuss::testing {
namespace {

const std::string roles = "master = \"rod.face\"\nslave = \"hammer.top\"",
                  joint = "[contact_solver]\nscheme = \"joint\"\n";

std::string with(const std::string& lines) { return changed(small_scene, roles, lines) + joint; }

TEST(ContactBodies, HaveNoRolesAndTheSchemeThatNeedsNone) {
    const Scene scene = parse_scene(with("bodies = [\"rod\", \"hammer\"]"), "scene.toml");
    EXPECT_EQ(faults_of(with("bodies = [\"rod\", \"hammer\"]")), "");
    const ContactPair& pair = scene.contacts[0];
    EXPECT_TRUE(pair.by_bodies);
    EXPECT_EQ(pair.scheme, RowScheme::symmetric);
    EXPECT_EQ(pair.master.body, "rod") << "forces are counted on it";
    EXPECT_EQ(pair.slave.body, "hammer");
    EXPECT_EQ(parse_scene(with(roles), "scene.toml").contacts[0].scheme, RowScheme::node_to_side);
    const auto chosen = with("bodies = [\"rod\", \"hammer\"]\nscheme = \"segment-to-segment\"");
    EXPECT_EQ(parse_scene(chosen, "scene.toml").contacts[0].scheme, RowScheme::segment_to_segment);
}

TEST(ContactBodies, GiveTheirRolesBySoftnessThenSizeOfCellsThenOrder) {
    const auto fine = [](const std::string& first, const std::string& second, std::string text) {
        const Scene scene = parse_scene(
            changed(text, "PAIR", fmt::format("bodies = [\"{}\", \"{}\"]", first, second)), "scene.toml");
        return first_is_fine(scene, build_mesh(scene), scene.contacts[0]) ? first : second;
    };
    const auto both_ways = [&](const std::string& text) {
        const std::string one = fine("rod", "hammer", text);
        EXPECT_EQ(fine("hammer", "rod", text), one);
        return one;
    };
    const std::string equal = with("PAIR");
    EXPECT_EQ(both_ways(equal), "hammer")
        << "cells of 1 mm both, but for those on the axis: the first of the scene";
    const std::string finer = changed(equal, "divisions = [4, 8]", "divisions = [5, 10]");
    EXPECT_EQ(both_ways(finer), "rod");
    const std::string soft = changed(finer, "velocity = [0, 10]", "velocity = [0, 10] # soft");
    const std::string plastic =
        changed(changed(soft, "material = \"steel\"\nvelocity", "material = \"lead\"\nvelocity"), "[[body]]",
                "[[material]]\nname = \"lead\"\ndensity = 7.85e-6\nyoung = 210\npoisson = 0.3\nplastic = { "
                "yield = 0.1 "
                "}\n[[body]]");
    EXPECT_EQ(both_ways(plastic), "hammer") << "softer, though its cells are larger";
}

TEST(ContactBodies, FaultsAreToldWithTheirCure) {
    const std::string both = "bodies = [\"rod\", \"hammer\"]";
    EXPECT_EQ(faults_of(changed(small_scene, roles, both)), "") << "the joint problem, unasked";
    EXPECT_EQ(faults_of(changed(small_scene, roles, both) + "[contact_solver]\nscheme = \"projection\"\n"),
              "scene.toml:35:10: the scheme \"projection\" needs roles; name 'master' and 'slave', or write "
              "scheme = "
              "\"joint\" in [contact_solver]");
    EXPECT_EQ(faults_of(with(both + "\nmaster = \"rod.face\"")),
              "scene.toml:36:10: 'bodies' knows no roles; leave 'master' out, or name 'master' and 'slave' "
              "instead of "
              "'bodies'");
    EXPECT_EQ(faults_of(with("bodies = [\"rod\"]")),
              "scene.toml:35:10: a pair has two bodies, these are 1; write bodies = [\"A\", \"B\"], or "
              "[\"A\", \"A\"] for a body that folds on itself");
    EXPECT_EQ(faults_of(with("bodies = [\"rod\", \"hamer\"]")),
              "scene.toml:35:10: unknown body 'hamer'; did you mean 'hammer'?");
    EXPECT_EQ(faults_of(with(both + "\nscheme = \"symetric\"")),
              "scene.toml:36:10: unknown contact scheme 'symetric'; did you mean 'symmetric'?");
    EXPECT_EQ(faults_of(changed(small_scene, roles, roles + "\nscheme = \"symmetric\"")),
              "scene.toml:37:10: the scheme \"projection\" knows no other rows; write scheme = \"joint\" in "
              "[contact_solver], or leave 'scheme' out");
}

TEST(ContactBodies, OverlapOfATenthOfASideIsRemembered) {
    const auto reaching = [&](double height, const std::string& text) {
        const auto top = fmt::format("{}", height);
        return faults_of(changed(text, "corners = [[0, -2], [4, -2], [4, 0], [0, 0]]",
                                 "corners = [[0, -2], [4, -2], [4, " + top + "], [0, " + top + "]]"));
    };
    const std::string bodies = with("bodies = [\"rod\", \"hammer\"]");
    EXPECT_EQ(reaching(0.09, bodies), "");
    EXPECT_EQ(reaching(0.09, with(roles)), "");
    EXPECT_NE(reaching(0.09, small_scene), "") << "the projection would throw it out";
    EXPECT_EQ(reaching(0.25, with(roles)),
              "scene.toml:33:1: contact 'hit': body 'rod' overlaps body 'hammer' by 0.25 mm at (0, 0) mm; "
              "move them "
              "apart until they touch or leave a gap, or overlap by no more than 0.1 mm, a tenth of the "
              "smallest side");
}

}  // namespace
}  // namespace percuss::testing
