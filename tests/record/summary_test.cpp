#include "record/summary.hpp"

#include <array>
#include <limits>
#include <memory>
#include <optional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace percuss {
namespace {

using testing::ElementsAre;

RunSetup rods() {
    RunSetup setup;
    Scene& scene = setup.scene;
    scene.duration = 6;
    scene.bodies.resize(2);
    setup.mesh.bodies.resize(2);
    scene.bodies[0].name = "striker";
    scene.bodies[1].name = "rod";
    scene.contacts.resize(1);
    scene.contacts[0].name = "impact";
    scene.parameters.resize(1);
    scene.parameters[0].name = "shank";
    scene.parameters[0].value = 4.2;
    scene.exact = {{"contact.impact.axial", "1D wave theory", {{0, 2}, {4, 2}}, 0.5, {}}};
    return setup;
}

RunStatistics statistics() {
    RunStatistics s;
    s.steps = 1000;
    s.cells = 750;
    s.step_seconds = 2;
    s.seconds = {1.5, 0.03, 0.05, 0.3, 0, 0, 0, 0.1, 0.7, 0.9};
    s.total_seconds = 4;
    s.dt_min = 1e-4;
    s.dt_max = 2e-4;
    s.critical_step_initial = 4e-4;
    s.initial_energy = 12;
    s.maximum_loss = 0.005;
    s.momentum_initial = {3, 10};
    s.momentum_final = {0, 10.5};
    s.momentum_scale = 10;
    PairStatistics pair;
    pair.peak_force = 63;
    pair.events = 2;
    pair.openings = 6;
    pair.closings = 6;
    pair.impulse = {0, 2.5};
    s.pairs = {pair};
    s.state_hash = "0123456789abcdef";
    return s;
}

Snapshot last() {
    Snapshot snapshot;
    snapshot.status = RunStatus::finished;
    snapshot.bodies = {{{0, 0.01}}, {{0, 5.02}}};
    snapshot.energy.kinetic = 11;
    snapshot.energy.internal = 0.9;
    return snapshot;
}

std::unique_ptr<History> doubled_pulse() {
    auto history = std::make_unique<History>(
        std::vector<HistoryColumn>{{"time", Quantity::time}, {"contact.impact.axial", Quantity::force}});
    for (int n = 0; n <= 6000; ++n) {
        const double time = 0.001 * n;
        history->append(std::array{time, time > 0 && time < 4 ? 4.0 : 0.0});
    }
    return history;
}

TEST(Summary, HoldsWhatARunIsJudgedBy) {
    const auto summary = make_summary(rods(), statistics(), *doubled_pulse(), last());
    const auto at = [&](const char* path) { return summary_value(summary, path).value_or(-999); };
    EXPECT_EQ(at("steps"), 1000);
    EXPECT_EQ(at("elements"), 750);
    EXPECT_EQ(at("parameters.shank"), 4.2);
    EXPECT_DOUBLE_EQ(at("contact_share"), 0.04);
    EXPECT_DOUBLE_EQ(at("element_steps_per_second"), 375'000);
    EXPECT_EQ(at("wall_seconds.contact_solve"), 0.05);
    EXPECT_EQ(at("wall_seconds.step_total"), 2);
    EXPECT_EQ(at("wall_seconds.total"), 4);
    EXPECT_EQ(at("wall_seconds.render"), 0.9);
    EXPECT_EQ(at("dt_max"), 2e-4);
    EXPECT_EQ(at("energy.initial"), 12);
    EXPECT_EQ(at("energy.maximum_loss"), 0.005);
    EXPECT_DOUBLE_EQ(at("energy.final"), 11.9);
    EXPECT_DOUBLE_EQ(at("momentum.error"), 0.05);  // axial alone: a ring's radial components cancel
    EXPECT_EQ(at("momentum.initial.radial"), 3);
    EXPECT_EQ(at("momentum.initial.axial"), 10);
    EXPECT_EQ(at("momentum.final.axial"), 10.5);
    EXPECT_EQ(at("contact.impact.open_close_events"), 2);
    EXPECT_EQ(at("contact.impact.node_openings"), 6);
    EXPECT_EQ(at("contact.impact.impulse.axial"), 2.5);
    EXPECT_EQ(at("body.rod.velocity.axial"), 5.02);
    EXPECT_NEAR(at("exact.contact.impact.axial.error_averaged"), 1, 1e-3);
    EXPECT_DOUBLE_EQ(at("exact.contact.impact.axial.first_sample"), 2);
    EXPECT_EQ(summary["state_hash"], "0123456789abcdef");
    EXPECT_EQ(summary["status"], "finished");
    EXPECT_EQ(summary["units"]["force"], "kN");
}

TEST(Summary, CountsBothDirectionsOfPlaneMomentum) {
    RunSetup setup = rods();
    setup.scene.geometry = Geometry::plane_strain;
    setup.scene.exact.clear();
    const auto summary = make_summary(setup, statistics(), *doubled_pulse(), last());
    EXPECT_DOUBLE_EQ(summary_value(summary, "momentum.error").value_or(-1), 0.3);
    EXPECT_EQ(summary_value(summary, "body.rod.velocity.y"), 5.02);
    EXPECT_TRUE(summary["momentum"].contains("angular_final"));
}

// The impulse of supports and loads is no error; it counts among what the error is measured by.
TEST(Summary, MomentumErrorLeavesOutWhatCameFromOutside) {
    RunStatistics s = statistics();
    s.external_impulse = {0, 0.25};
    s.external_impulse_gross = 2.5;
    const auto summary = make_summary(rods(), s, *doubled_pulse(), last());
    EXPECT_DOUBLE_EQ(summary_value(summary, "momentum.error").value_or(-1), 0.25 / 12.5);
    EXPECT_EQ(summary_value(summary, "momentum.external_impulse.axial"), 0.25);
}

TEST(Summary, TellsWhatTheJointSolverDid) {
    RunSetup setup = rods();
    setup.scene.contact_solver.scheme = ContactScheme::joint;
    RunStatistics s = statistics();
    s.contact_solver = {10, 12, 1, 50, 3, 20};
    s.contact_energy_in = 0.002;
    const auto summary = make_summary(setup, s, *doubled_pulse(), last());
    EXPECT_EQ(summary["contact_solver"]["scheme"], "joint");
    EXPECT_DOUBLE_EQ(summary_value(summary, "contact_solver.iterations_mean").value_or(-1), 1.2);
    EXPECT_EQ(summary_value(summary, "contact_solver.iterations_max"), 3);
    EXPECT_DOUBLE_EQ(summary_value(summary, "contact_solver.rows_mean").value_or(-1), 5);
    EXPECT_EQ(summary_value(summary, "contact_solver.fallbacks"), 1);
    EXPECT_EQ(summary_value(summary, "energy.contact_in"), 0.002);
    EXPECT_FALSE(summary["contact_solver"].contains("friction"));
    EXPECT_FALSE(summary["energy"].contains("friction"));
}

TEST(Summary, TellsWhatFrictionDid) {
    RunSetup setup = rods();
    setup.scene.contact_solver.scheme = ContactScheme::joint;
    setup.scene.contacts[0].friction = 0.2;
    RunStatistics s = statistics();
    s.contact_solver.friction_solutions = 20;
    s.contact_solver.friction_rounds = 30;
    s.contact_solver.most_friction_rounds = 4;
    s.contact_solver.unsettled = 1;
    s.pairs[0].friction_work = -2;
    Snapshot end = last();
    end.energy.friction = -2.5;
    const auto summary = make_summary(setup, s, *doubled_pulse(), end);
    EXPECT_EQ(summary_value(summary, "contact_solver.friction.rounds_mean"), 1.5);
    EXPECT_EQ(summary_value(summary, "contact_solver.friction.rounds_max"), 4);
    EXPECT_EQ(summary_value(summary, "contact_solver.friction.unsettled"), 1);
    EXPECT_EQ(summary_value(summary, "contact.impact.friction_work"), -2);
    EXPECT_EQ(summary_value(summary, "energy.friction"), -2.5);
}

TEST(Summary, FindsPeaksTouchesAndStopsInTheHistories) {
    History history({{"time", Quantity::time},
                     {"contact.impact.axial", Quantity::force},
                     {"contact.impact.active", Quantity::dimensionless},
                     {"body.striker.velocity.axial", Quantity::velocity},
                     {"body.rod.velocity.axial", Quantity::velocity}});
    for (const auto& row : {std::array{0.0, 0.0, 0.0, 10.0, 0.0}, std::array{1.0, 3.0, 2.0, 6.0, 2.0},
                            std::array{2.0, -7.0, 1.0, 2.0, 4.0}, std::array{3.0, 0.0, 0.0, -2.0, 5.0}})
        history.append(row);
    const auto summary = make_summary(rods(), statistics(), history, last());
    const auto at = [&](const char* path) { return summary_value(summary, path); };
    EXPECT_EQ(at("contact.impact.peak.axial.value"), -7);
    EXPECT_EQ(at("contact.impact.peak.axial.time"), 2);
    EXPECT_EQ(at("contact.impact.first_touch"), 1);
    EXPECT_EQ(at("contact.impact.last_touch"), 2);
    EXPECT_EQ(at("body.striker.stops.axial"), 2.5);
    EXPECT_EQ(at("body.striker.velocity_min.axial"), -2);
    EXPECT_EQ(at("body.striker.velocity_max.axial"), 10);
    EXPECT_EQ(at("body.rod.stops.axial"), std::nullopt) << "it did not move at the start";
}

TEST(Summary, KeepsBodiesAndTheirEnergiesApart) {
    RunSetup setup = rods();
    setup.mesh.bodies[0].node_end = setup.mesh.bodies[1].node_begin = 2;
    setup.mesh.bodies[1].node_end = 4;
    setup.mesh.bodies[0].cell_end = setup.mesh.bodies[1].cell_begin = 1;
    setup.mesh.bodies[1].cell_end = 2;
    Snapshot end = last();
    end.position = {0, 1, 2, 5, /* the rod's */ 3, -7, 4, -1};
    end.plastic_strain = {0.5, 0.25};
    RunStatistics counted = statistics();
    counted.bodies = {{1, 2, 3, 4, 5}, {6, 7, 8, 9, 10}};
    const auto summary = make_summary(setup, counted, *doubled_pulse(), end);
    const auto at = [&](const char* path) { return summary_value(summary, path).value_or(-999); };
    EXPECT_EQ(at("body.striker.extent.radial.max"), 2);
    EXPECT_EQ(at("body.striker.extent.axial.length"), 4);
    EXPECT_EQ(at("body.rod.extent.radial.min"), 3);
    EXPECT_EQ(at("body.rod.extent.axial.min"), -7);
    EXPECT_EQ(at("body.rod.extent.axial.max"), -1);
    EXPECT_EQ(at("body.striker.plastic_strain_max"), 0.5);
    EXPECT_EQ(at("body.rod.plastic_strain_max"), 0.25);
    EXPECT_EQ(at("body.striker.energy.kinetic"), 1);
    EXPECT_EQ(at("body.striker.energy.elastic"), 2);
    EXPECT_EQ(at("body.striker.energy.plastic"), 3);
    EXPECT_EQ(at("body.rod.energy.hourglass"), 9);
    EXPECT_EQ(at("body.rod.energy.viscous"), 10);
}

TEST(SummaryValue, FindsNamesWithDotsAndNothingElse) {
    const auto summary = nlohmann::ordered_json::parse(
        R"({"a": {"b": {"c": 1}, "b.d": {"c": 2}}, "a.b": {"x": 3}, "text": "4"})");
    EXPECT_EQ(summary_value(summary, "a.b.c"), 1);
    EXPECT_EQ(summary_value(summary, "a.b.d.c"), 2);
    EXPECT_EQ(summary_value(summary, "a.b.x"), 3);
    EXPECT_EQ(summary_value(summary, "a.b"), std::nullopt);
    EXPECT_EQ(summary_value(summary, "text"), std::nullopt);
    EXPECT_EQ(summary_value(summary, "a.bc"), std::nullopt);
}

TEST(Expectations, SayWhatWasPromisedAndWhatCame) {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    Scene scene;
    scene.expect = {{"contact.impact.peak_force", 61.8, 65.8, "rho c A V/2", {}},
                    {"steps", 0, 10, "", {}},
                    {"energy.maximum_growth", -infinite, 1e-9, "never grows", {}},
                    {"steps", 11, infinite, "", {}},
                    {"events", 2, 2, "", {}},
                    {"nothing.here", 1, 3, "", {}}};
    const auto summary = nlohmann::ordered_json::parse(
        R"({"contact": {"impact": {"peak_force": 70.1}}, "steps": 10, "energy": {"maximum_growth": 0.04}, "events": 3})");
    EXPECT_THAT(broken_expectations(scene, summary),
                ElementsAre("contact.impact.peak_force is 70.1, promised 63.8 +- 2 (rho c A V/2)",
                            "energy.maximum_growth is 0.04, promised at most 1e-09 (never grows)",
                            "steps is 10, promised at least 11", "events is 3, promised 2",
                            "nothing.here is missing from the summary, promised 2 +- 1"));
    const auto all = check_expectations(scene, summary);
    ASSERT_EQ(all.size(), 6U);
    EXPECT_TRUE(all[1].kept);
    EXPECT_EQ(all[1].text, "steps is 10, promised 5 +- 5");
}

}  // namespace
}  // namespace percuss
