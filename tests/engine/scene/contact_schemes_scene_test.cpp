#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/scene/small_scene.hpp"

namespace percuss::testing {
namespace {

using ::testing::EndsWith;

const std::string slave = "slave = \"hammer.top\"";

std::string pair_with(const std::string& line, const std::string& solver = "scheme = \"joint\"") {
    return changed(small_scene, slave, slave + "\n" + line) + "[contact_solver]\n" + solver + "\n";
}

TEST(ContactSchemesOfScenes, AreRead) {
    const Scene plain = parse_scene(pair_with(""), "scene.toml");
    EXPECT_EQ(plain.contacts[0].level, ContactLevel::position);
    EXPECT_FALSE(plain.contacts[0].layer);
    EXPECT_EQ(plain.contact_solver.solver, ForceSolver::active_set);
    const Scene velocity = parse_scene(pair_with("level = \"velocity\"\nlayer = { viscosity = 0.1 }",
                                                 "scheme = \"joint\"\nsolver = \"conjugate-gradient\""),
                                       "scene.toml");
    EXPECT_EQ(velocity.contacts[0].level, ContactLevel::velocity);
    EXPECT_EQ(velocity.contacts[0].layer, (ContactLayer{0.1, 3}));
    EXPECT_EQ(velocity.contact_solver.solver, ForceSolver::conjugate_gradient);
    const Scene penalty = parse_scene(pair_with("scheme = \"symmetric\"\nfriction = 0.1",
                                                "scheme = \"penalty\"\npenalty = 0.3\nstep = \"elements\""),
                                      "scene.toml");
    EXPECT_EQ(penalty.contact_solver.scheme, ContactScheme::penalty);
    EXPECT_EQ(penalty.contact_solver.penalty, 0.3);
    EXPECT_TRUE(penalty.contact_solver.step_of_elements);
    EXPECT_EQ(penalty.contacts[0].scheme, RowScheme::symmetric);
}

TEST(ContactSchemesOfScenes, FaultsAreToldWithTheirCure) {
    EXPECT_THAT(faults_of(changed(small_scene, slave, slave + "\nlevel = \"velocity\"")),
                EndsWith("levels of pairs belong to the joint problem; write scheme = \"joint\" in "
                         "[contact_solver], or leave 'level' out"));
    EXPECT_THAT(faults_of(pair_with("level = \"velocity\"", "scheme = \"penalty\"")),
                EndsWith("or leave 'level' out"));
    EXPECT_THAT(faults_of(pair_with("", "scheme = \"joint\"\npenalty = 0.1")),
                EndsWith("'penalty' belongs to scheme = \"penalty\" or \"bipenalty\"; leave it out or choose "
                         "that scheme"));
    EXPECT_THAT(faults_of(pair_with("", "scheme = \"bipenalty\"\nstep = \"elements\"")),
                EndsWith("'step' belongs to scheme = \"penalty\"; leave it out or choose that scheme"));
    EXPECT_THAT(faults_of(pair_with("", "scheme = \"penalty\"\nsolver = \"gauss-seidel\"")),
                EndsWith("'solver' belongs to scheme = \"joint\" or \"bipenalty\"; leave it out or choose "
                         "that scheme"));
    EXPECT_THAT(faults_of(pair_with("friction = 0.1", "scheme = \"projection\"")),
                EndsWith("the scheme \"projection\" knows no friction; write scheme = \"joint\" in "
                         "[contact_solver], or leave 'friction' out"));
    EXPECT_THAT(faults_of(pair_with("layer = { layers = 2 }")), ::testing::HasSubstr("viscosity = 0.06"));
}

}  // namespace
}  // namespace percuss::testing
