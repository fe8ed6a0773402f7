#include <gtest/gtest.h>

#include "engine/scene/small_scene.hpp"

namespace percuss::testing {
namespace {

Scene with(const std::vector<std::string>& overrides) {
    return parse_scene(small_scene, "scene.toml", overrides);
}

std::string refused(const std::string& override) { return faults_of(small_scene, {override}); }

TEST(Override, ReachesEveryKindOfValue) {
    const auto scene =
        with({"model.step.courant=0.25", "body.hammer.velocity=[0, -20]", "body.rod.velocity=[1,2]",
              "contact.hit.sign=\"unrestricted\"", "body.rod.block.0.divisions=[2,3]",
              "body.hammer.velocity.0=5", "title=two rods", "contact.0.master=rod.bottom",
              "body.1.block.0.names.bottom=bottom", "record.frames=1e-3", "model.lagged=true"});
    EXPECT_EQ(scene.step.courant, 0.25);
    EXPECT_EQ(scene.bodies[0].velocity, (std::array{5.0, -20.0}));
    EXPECT_EQ(scene.bodies[1].velocity, (std::array{1.0, 2.0}));
    EXPECT_EQ(scene.contacts[0].sign, ContactSign::unrestricted);
    EXPECT_EQ(scene.bodies[1].blocks[0].divisions, (std::array{2, 3}));
    EXPECT_EQ(scene.title, "two rods");
    EXPECT_EQ(scene.contacts[0].master.edge, "bottom");
    EXPECT_EQ(scene.record.frames, 1e-3);
    EXPECT_TRUE(scene.lagged);
    EXPECT_EQ(scene.overrides.size(), 11U);
}

TEST(Override, OfFixedStepTakesCourantAwayAndTheReverse) {
    EXPECT_EQ(with({"model.step.fixed=2e-4"}).step.fixed, 2e-4);
    EXPECT_FALSE(with({"model.step.fixed=2e-4", "model.step.courant=0.7"}).step.fixed);
}

TEST(Override, OfTheContactSchemeTakesAwayWhatOthersSay) {
    const auto springs =
        small_scene + "[contact_solver]\nscheme = \"penalty\"\npenalty = 0.3\nstep = \"elements\"\n";
    const auto solver = [&](const std::vector<std::string>& overrides) {
        return parse_scene(springs, "scene.toml", overrides).contact_solver;
    };
    const std::string key = "contact_solver.scheme=";
    EXPECT_EQ(solver({key + "joint"}).scheme, ContactScheme::joint);
    EXPECT_EQ(solver({key + "projection"}).scheme, ContactScheme::projection);
    EXPECT_EQ(solver({key + "bipenalty"}).penalty, 0.3) << "it has springs, too";
    EXPECT_FALSE(solver({key + "\"bipenalty\""}).step_of_elements);
    // The last one counts: nothing is lost on the way there and back.
    const ContactSolver back = solver({key + "joint", key + "penalty"});
    EXPECT_EQ(back.penalty, 0.3);
    EXPECT_TRUE(back.step_of_elements);
    EXPECT_EQ(solver({"contact_solver.penalty=2", key + "joint"}).scheme, ContactScheme::joint);
    // What is asked for after it is a fault as ever.
    EXPECT_THROW(solver({key + "joint", "contact_solver.penalty=2"}), SceneError);
    const auto joint = small_scene +
                       "[contact_solver]\nscheme = \"joint\"\nrecovery_speed = 2\nsolver = "
                       "\"gauss-seidel\"\n";
    for (const char* scheme : {"penalty", "bipenalty", "projection"})
        EXPECT_NO_THROW(parse_scene(joint, "scene.toml", {key + scheme})) << scheme;
    EXPECT_EQ(parse_scene(joint, "scene.toml", {key + "bipenalty"}).contact_solver.solver,
              ForceSolver::gauss_seidel);
}

TEST(Override, ReachesPromisesWithDotsInTheirPath) {
    const auto text = small_scene + "[expect]\n\"energy.maximum_loss\" = { value = 1, tolerance = 2 }\n";
    const auto scene = parse_scene(
        text, "scene.toml",
        {"expect.energy.maximum_loss.tolerance=0.5", "expect.steps.max=7", "expect.\"body.rod\".min=1"});
    ASSERT_EQ(scene.expect.size(), 3U);
    EXPECT_EQ(scene.expect[0].path, "body.rod");
    EXPECT_EQ(scene.expect[1].path, "energy.maximum_loss");
    EXPECT_EQ(scene.expect[1].max, 1.5);
    EXPECT_EQ(scene.expect[2].path, "steps");
}

TEST(Override, IsNamedAsThePlaceOfItsFaults) {
    EXPECT_EQ(refused("model.step.courant=2"),
              "--set model.step.courant=2: 'courant' is 2; it must be > 0 and <= 1");
    EXPECT_EQ(refused("model.step.courrant=2"),
              "--set model.step.courrant=2: unknown key 'courrant' in [model.step]; did you mean 'courant'?");
    EXPECT_EQ(refused("modle.duration=2"),
              "--set modle.duration=2: unknown key 'modle' in the scene; did you mean 'model'?");
    EXPECT_EQ(refused("body.hamer.velocity=[0,1]"),
              "--set body.hamer.velocity=[0,1]: there is no body 'hamer'; did you mean 'hammer'?");
    EXPECT_EQ(refused("body.rod.block.3.divisions=[1,1]"),
              "--set body.rod.block.3.divisions=[1,1]: there is no block '3'; there are 1, counted from 0");
    EXPECT_EQ(refused("body.hammer.velocity.1=fast"),
              "--set body.hammer.velocity.1=fast: 'velocity[1]' is a string; it must be a number");
    EXPECT_EQ(refused("percuss.version=1"),
              "--set percuss.version=1: 'percuss' is an integer and has no 'version'; set 'percuss' itself");
    EXPECT_EQ(refused("body.rod.block.0.corners=[[0,0],[0,8],[4,8],[4,0]]"),
              "--set body.rod.block.0.corners=[[0,0],[0,8],[4,8],[4,0]]: body 'rod': all cells are inverted; "
              "list the "
              "corners counter-clockwise");
}

TEST(Override, ThatIsNoAssignmentIsRefused) {
    EXPECT_EQ(refused("model.lagged"),
              "--set model.lagged: no value; write --set KEY=VALUE, e.g. --set model.step.courant=0.5");
    EXPECT_EQ(refused("model..lagged=true"),
              "--set model..lagged=true: 'model..lagged' is not a key; write e.g. "
              "model.step.courant");
    EXPECT_EQ(refused("body.rod.velocity=[1").find("--set body.rod.velocity=[1: the value for"), 0U);
}

TEST(WaveSpeed, AbsurdInTheDeclaredUnitsIsAWarningThatNamesTheSlip) {
    const auto warnings = [](const std::vector<std::string>& overrides) { return with(overrides).warnings; };
    EXPECT_TRUE(warnings({}).empty());
    EXPECT_EQ(parse_scene(changed(small_scene, "7.85e-6", "7.85e-9"), "scene.toml").warnings,
              std::vector<std::string>{
                  "scene.toml:13:11: warning: material 'steel' has a wave speed of 1.64e+05 m/s in "
                  "the declared units mm, ms, kg, where 50 to 20000 m/s are usual; density = "
                  "7.85e-09 looks like t/mm^3, which is 7.85e-06 kg/mm^3"});
    EXPECT_EQ(warnings({"material.steel.young=210000"}),
              std::vector<std::string>{
                  "--set material.steel.young=210000: warning: material 'steel' has a wave speed of "
                  "1.64e+05 m/s in the declared units mm, ms, kg, where 50 to 20000 m/s are usual; "
                  "young = 210000 looks like MPa, which is 210 GPa"});
}

}  // namespace
}  // namespace percuss::testing
