// Values that change while a run is under way: as if they had always been so when they change at the start,
// the same again when the run is set back, and nothing at all when they do not differ.
#include <cmath>
#include <functional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/run/change_values.hpp"
#include "engine/scene/small_scene.hpp"
#include "run/engine.hpp"
#include "scene/parse.hpp"
#include "verification/kinds.hpp"

namespace percuss {
namespace {

using percuss::testing::changed;
using percuss::testing::small_scene;

const std::string viscous =
    changed(small_scene, "poisson = 0.3", "poisson = 0.3\nviscosity = { linear = 0.06, quadratic = 1.2 }");
const std::string loaded = changed(small_scene, "velocity = [0, 10]", "body_force = [0, 1000]") +
                           "[[body]]\nname = \"block\"\nmaterial = \"steel\"\n[[body.block]]\n"
                           "corners = [[5, 0], [9, 0], [9, 4], [5, 4]]\ndivisions = [3, 3]\n"
                           "[[body.load]]\nedge = \"right\"\npressure = [[0, 0], [0.01, 0.5]]\n";

/// One value of a scene that can change in flight.
struct Change {
    const char* name;
    std::function<Scene(const std::vector<std::string>&)> scene;
    std::string key, from, to;
    std::int64_t steps = 130;
};
void PrintTo(const Change& change, std::ostream* to) { *to << change.name; }

std::function<Scene(const std::vector<std::string>&)> of(const std::string& text) {
    return [text](const auto& overrides) { return parse_scene(text, "scene.toml", overrides); };
}
std::function<Scene(const std::vector<std::string>&)> nail(std::vector<std::string> more) {
    more.emplace_back("parameters.mesh=0.5");
    return [more](std::vector<std::string> overrides) {
        overrides.insert(overrides.begin(), more.begin(), more.end());
        return load_scene(PERCUSS_SOURCE_DIR "/scenes/nail.toml", overrides);
    };
}

const Change changes[] = {
    {"step", of(small_scene), "model.step.courant", "0.5", "0.7"},
    {"linear_viscosity", of(viscous), "material.steel.viscosity.linear", "0.06", "0.2"},
    {"quadratic_viscosity", of(viscous), "material.steel.viscosity.quadratic", "1.2", "8"},
    {"viscosity_of_averaged_triangles",
     of(changed(viscous, "name = \"rod\"", "name = \"rod\"\nelement = \"averaged triangle\"")),
     "material.steel.viscosity.linear", "0.06", "0.3"},
    {"hourglass", of(changed(small_scene, "name = \"rod\"", "name = \"rod\"\nhourglass = 0.1")),
     "body.rod.hourglass", "0.1", "0.02"},
    {"gravity", of(loaded), "body.hammer.body_force", "[0, 1000]", "[0, 5000]"},
    {"pressure", of(loaded), "body.block.load.0.pressure", "[[0, 0], [0.01, 0.5]]", "0.3"},
    {"friction", nail({"parameters.friction=0.1"}), "parameters.friction", "0.1", "0.02", 1200},
    {"recovery_speed", nail({"contact_solver.recovery_speed=1"}), "contact_solver.recovery_speed", "1",
     "0.01", 1200},
    {"solver", nail({"contact_solver.solver=active-set"}), "contact_solver.solver", "active-set",
     "conjugate-gradient", 1200},
    {"scheme", nail({}), "contact_solver.scheme", "joint", "projection", 1200},
    {"scheme_back", nail({"contact_solver.scheme=projection"}), "contact_solver.scheme", "projection",
     "joint", 1200},
};

class ChangeInFlight : public ::testing::TestWithParam<Change> {
  protected:
    [[nodiscard]] Scene scene(const std::string& value) const {
        return GetParam().scene({GetParam().key + "=" + value});
    }
    [[nodiscard]] Solver solver() const { return Solver(scene(GetParam().from)); }
    [[nodiscard]] std::int64_t steps() const { return GetParam().steps; }
    [[nodiscard]] command::Set to(const std::string& value) const { return {GetParam().key, value}; }
    static void go(Engine& engine, Command command) {
        engine.post(std::move(command));
        engine.wait();
        EXPECT_THAT(engine.take_messages(), ::testing::IsEmpty());
    }
    static std::string hash(const Engine& engine) { return engine.statistics().state_hash; }
    static std::vector<double> rows(const Engine& engine) {
        return engine.history()->table(0, engine.history()->rows());
    }
};

TEST_P(ChangeInFlight, IsSaidBeforehand) {
    EXPECT_EQ(effect_of_change(scene(GetParam().from), scene(GetParam().to)), ChangeEffect::next_step);
    EXPECT_EQ(effect_of_change(scene(GetParam().from), scene(GetParam().from)), ChangeEffect::none);
}

TEST_P(ChangeInFlight, AtTheStartIsTheSceneBuiltWithIt) {
    Engine built(scene(GetParam().to)), changed(scene(GetParam().from));
    const auto setup = changed.snapshot()->setup;
    go(changed, to(GetParam().to));
    EXPECT_EQ(changed.snapshot()->setup, setup) << "it was built anew";
    for (Engine* engine : {&built, &changed}) go(*engine, command::Steps{steps()});
    EXPECT_EQ(hash(changed), hash(built));
    EXPECT_EQ(rows(changed), rows(built));
    EXPECT_EQ(changed.statistics().critical_step_initial, built.statistics().critical_step_initial);
    EXPECT_EQ(changed.statistics().critical_step_min, built.statistics().critical_step_min);
}

TEST_P(ChangeInFlight, OfTheSameValueIsNone) {
    Engine left_alone(scene(GetParam().from)), set(scene(GetParam().from));
    go(left_alone, command::Steps{steps()});
    go(set, command::Steps{steps() / 2});
    go(set, to(GetParam().from));
    // There and back before a step is made.
    go(set, to(GetParam().to));
    go(set, to(GetParam().from));
    go(set, command::Steps{steps() - steps() / 2});
    EXPECT_EQ(hash(set), hash(left_alone));
    EXPECT_EQ(rows(set), rows(left_alone));
}

TEST_P(ChangeInFlight, IsMadeAgainWhenTheRunIsSetBack) {
    Engine engine(scene(GetParam().from)), left_alone(scene(GetParam().from));
    const std::int64_t half = steps() / 2 + 3;  // no multiple of the steps between kept states
    constexpr std::int64_t soon = 20;           // no state is kept so soon after
    go(engine, command::Steps{half});
    const std::string before = hash(engine);
    go(engine, to(GetParam().to));
    go(engine, command::Steps{soon});
    const std::string after = hash(engine);
    go(engine, command::Steps{steps() - half - soon});
    const std::string end = hash(engine);
    const auto seek = [&](std::int64_t step) {
        const auto& rows = engine.history()->values("time");
        const auto row = static_cast<std::size_t>(step);
        go(engine, command::Seek{row < rows.size() ? rows[row] : 1e9});
        EXPECT_EQ(engine.snapshot()->step, step);
    };
    go(left_alone, command::Steps{steps()});
    EXPECT_NE(hash(left_alone), end) << "the change had no effect";

    for (const std::int64_t back : {half - 2, half, half + 1, std::int64_t{0}}) {
        seek(back);
        if (back == half) {
            EXPECT_EQ(hash(engine), before);
        }
        seek(half + soon);
        EXPECT_EQ(hash(engine), after) << "from step " << back;
        seek(steps());
        EXPECT_EQ(hash(engine), end) << "from step " << back;
    }
    // A moment before the change, on from there: the present value counts from the branch on.
    seek(half - 2);
    go(engine, command::Steps{soon});
    Solver alone = solver();
    while (alone.steps() < half - 2) ASSERT_FALSE(alone.step());
    alone.change(std::make_shared<const InFlight>(in_flight(scene(GetParam().to))));
    while (alone.steps() < half - 3 + soon) ASSERT_FALSE(alone.step());
    const std::string nearly = alone.statistics().state_hash;
    ASSERT_FALSE(alone.step());
    EXPECT_EQ(hash(engine), alone.statistics().state_hash);
    seek(half - 5);
    seek(half - 3 + soon);  // not the last moment, which is kept
    EXPECT_EQ(hash(engine), nearly) << "the branch has forgotten its values";
}

TEST_P(ChangeInFlight, IsPartOfASavedState) {
    Solver first = solver(), second = solver();
    first.change(std::make_shared<const InFlight>(in_flight(scene(GetParam().to))));
    while (first.steps() < steps() - 40) ASSERT_FALSE(first.step());
    const SolverState saved = first.save();
    while (first.steps() < steps()) ASSERT_FALSE(first.step());
    second.restore(saved);
    while (second.steps() < steps()) ASSERT_FALSE(second.step());
    EXPECT_EQ(second.statistics().state_hash, first.statistics().state_hash);
}

INSTANTIATE_TEST_SUITE_P(Values, ChangeInFlight, ::testing::ValuesIn(changes),
                         [](const auto& change) { return std::string(change.param.name); });

TEST(ChangeInFlightOf, WhatTheSceneDoesNotCallForBuildsAnew) {
    const auto effect = [](const std::string& text, const std::string& override) {
        return effect_of_change(parse_scene(text, "a", {}), parse_scene(text, "b", {override}));
    };
    EXPECT_EQ(effect(small_scene, "material.steel.viscosity.linear=0.1"), ChangeEffect::rebuild);
    EXPECT_EQ(effect(small_scene, "body.rod.hourglass=0"), ChangeEffect::rebuild);
    EXPECT_EQ(effect(small_scene, "body.rod.body_force=[0, 1]"), ChangeEffect::rebuild);
    EXPECT_EQ(effect(loaded, "body.hammer.body_force=[0, 0]"), ChangeEffect::rebuild);
    EXPECT_EQ(effect(small_scene + "[contact_solver]\nscheme = \"joint\"\n", "contact.hit.friction=0.1"),
              ChangeEffect::rebuild);
    EXPECT_EQ(effect(small_scene, "material.steel.young=200"), ChangeEffect::rebuild);
    EXPECT_EQ(effect(small_scene, "view.field=pressure"), ChangeEffect::none);
    EXPECT_EQ(effect(small_scene, "model.duration=0.2"), ChangeEffect::rebuild);
    const std::string springs = small_scene + "[contact_solver]\nscheme = \"penalty\"\n";
    EXPECT_EQ(effect(springs, "contact_solver.penalty=0.5"), ChangeEffect::rebuild);
    EXPECT_EQ(effect(springs, "contact_solver.step=elements"), ChangeEffect::rebuild);
    EXPECT_EQ(effect(springs, "contact_solver.scheme=bipenalty"), ChangeEffect::rebuild);
    EXPECT_EQ(effect(springs, "contact_solver.scheme=joint"), ChangeEffect::rebuild);
    EXPECT_EQ(effect(small_scene, "contact_solver.scheme=massless"), ChangeEffect::rebuild);
    EXPECT_EQ(effect(small_scene, "contact_solver.scheme=joint"), ChangeEffect::next_step);
}

TEST(ChangeInFlightOf, AFixedStepAboveTheNewCriticalOneIsRefused) {
    Solver solver(parse_scene(viscous, "a", {"model.step.courant=0.99"}));
    ASSERT_FALSE(solver.step());
    const double critical = solver.critical_step();
    percuss::testing::change_values(solver, [&](InFlight& v) { v.step.fixed = 0.97 * critical; });
    const auto before = solver.in_force();
    EXPECT_THROW(percuss::testing::change_values(solver,
                                                 [](InFlight& v) {
                                                     for (auto& body : v.bodies) body.viscosity->linear = 1;
                                                 }),
                 SceneError);
    EXPECT_EQ(solver.in_force(), before);
    EXPECT_FALSE(solver.step());
    EXPECT_EQ(solver.critical_step(), critical) << "nothing has changed";
}

TEST(ChangeInFlightOf, TheSchemeOfARunUnderWayGainsNoEnergy) {
    for (const char* scheme : {"joint", "projection"}) {
        Engine engine(percuss::testing::nail(scheme));
        for (int k = 0; k < 8; ++k) {
            engine.post(command::Steps{400});
            engine.wait();
            ASSERT_EQ(engine.status(), RunStatus::paused) << engine.snapshot()->message;
            engine.post(command::Set{"contact_solver.scheme", k % 2 == 0 ? "joint" : "projection"});
        }
        EXPECT_LT(engine.statistics().maximum_growth, 1e-3) << scheme;
    }
}

TEST(ChangeInFlightOf, ASceneReadElsewhereIsTakenUp) {
    Engine engine(parse_scene(viscous, "a", {}));
    engine.post(command::Steps{10});
    engine.wait();
    const auto setup = engine.snapshot()->setup;
    const auto change = [&](const std::string& override) {
        engine.post(command::Change{std::make_shared<const Scene>(parse_scene(viscous, "a", {override}))});
        engine.wait();
    };
    change("material.steel.viscosity.linear=0.3");
    EXPECT_EQ(engine.scene()->materials[0].viscosity->linear, 0.3);
    EXPECT_EQ(engine.snapshot()->step, 10);
    change("material.steel.young=100");
    EXPECT_EQ(engine.snapshot()->step, 0) << "built anew";
    EXPECT_NE(engine.snapshot()->setup, setup);
    change("model.step.fixed=1");
    EXPECT_THAT(engine.take_messages(), ::testing::SizeIs(1));
    EXPECT_FALSE(engine.scene()->step.fixed);
}

}  // namespace
}  // namespace percuss
