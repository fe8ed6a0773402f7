#include "run/contact_forces.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace percuss {
namespace {

/// A nail held by a plate and pushed by a piston: radial forces that settle at 40 and 2, with chatter.
struct Held {
    Held() {
        scene.duration = 1;
        ContactPair hole, push;
        hole.name = "hole";
        hole.master = {"plate", "", {}};
        hole.slave = {"nail", "", {}};
        push.name = "push";
        push.master = {"nail", "", {}};
        push.slave = {"piston", "", {}};
        ContactPair apart;
        apart.name = "apart";
        apart.master = {"plate", "", {}};
        apart.slave = {"piston", "", {}};
        scene.contacts = {hole, push, apart};
        scene.analysis.pull_out = Analysis::PullOut{"nail", 0.3, {}};
        for (int k = 0; k <= 1000; ++k) {
            const double t = 0.001 * k, chatter = k % 2 == 0 ? 2 : 0;
            const double radial = t < 0.5 ? 100 * t * chatter : 20 * chatter;
            history.append(
                std::vector<double>{t, -1, radial, -14 * std::sin(3.14159265 * t), -chatter, 0, 999});
        }
    }
    Scene scene;
    History history{{{"time", Quantity::time},
                     {"contact.hole.axial", Quantity::force},
                     {"contact.hole.radial", Quantity::force},
                     {"contact.push.axial", Quantity::force},
                     {"contact.push.radial", Quantity::force},
                     {"contact.apart.axial", Quantity::force},
                     {"contact.apart.radial", Quantity::force}}};
};

TEST(ContactAnalysis, ResidualIsTheMeanOfTheLastPart) {
    const Held held;
    const ContactAnalysis analysis = analyse_contacts(held.scene, held.history);
    EXPECT_NEAR(analysis.residual_from, 0.9, 1e-9);
    EXPECT_NEAR(analysis.pairs[0].residual[0], 20, 0.5);
    EXPECT_NEAR(analysis.pairs[0].residual[1], -1, 1e-9);
    EXPECT_NEAR(analysis.pairs[1].residual[0], -1, 0.05);
}

TEST(ContactAnalysis, PeaksAreOfTheMovingAverageWithTheirTimes) {
    Held held;
    ContactAnalysis analysis = analyse_contacts(held.scene, held.history);
    EXPECT_NEAR(analysis.window, 0.005, 1e-12);  // a 200th of the duration
    EXPECT_NEAR(analysis.pairs[1].peak[1], -14, 0.01);
    EXPECT_NEAR(analysis.pairs[1].peak_time[1], 0.5, 0.01);
    held.scene.analysis.window = 0.1;
    analysis = analyse_contacts(held.scene, held.history);
    EXPECT_NEAR(analysis.pairs[0].peak[0], 45, 0.5);  // half of the chatter on the ramp from 80 to 100
    held.scene.analysis.window = 0;
    analysis = analyse_contacts(held.scene, held.history);
    EXPECT_NEAR(analysis.pairs[0].peak[0], 100, 0.5);
}

TEST(ContactAnalysis, TakesForcesThatDriveBodiesLikeThoseOfPairs) {
    Scene scene;
    scene.duration = 1;
    scene.bodies.resize(2);
    scene.bodies[0].name = "plate";
    scene.bodies[1].name = "nail";
    scene.bodies[1].prescribed.resize(1);
    History history({{"time", Quantity::time}, {"body.nail.drive.axial", Quantity::force}});
    for (int k = 0; k <= 1000; ++k)
        history.append(std::vector<double>{0.001 * k, 4 * std::sin(3.14159265 * 0.001 * k)});
    const ContactAnalysis analysis = analyse_contacts(scene, history);
    ASSERT_EQ(analysis.drives.size(), 1U);
    EXPECT_EQ(analysis.drives[0].name, "nail");
    EXPECT_NEAR(analysis.drives[0].peak[1], 4, 1e-3);
    EXPECT_NEAR(analysis.drives[0].peak_time[1], 0.5, 0.01);
    EXPECT_EQ(analysis.drives[0].peak[0], 0) << "moves freely along it";
}

TEST(PullOut, IsFrictionTimesTheNormalForcesOfThePairsOfTheBody) {
    Held held;
    const auto all = estimate_pull_out(held.scene, analyse_contacts(held.scene, held.history));
    ASSERT_TRUE(all);
    EXPECT_NEAR(all->normal_force, 21, 0.6);  // not the pair of plate and piston
    EXPECT_DOUBLE_EQ(all->force, 0.3 * all->normal_force);
    held.scene.analysis.pull_out->pairs = {"push"};
    EXPECT_NEAR(estimate_pull_out(held.scene, analyse_contacts(held.scene, held.history))->normal_force, 1,
                0.05);
    held.scene.analysis.pull_out.reset();
    EXPECT_FALSE(estimate_pull_out(held.scene, analyse_contacts(held.scene, held.history)));
}

}  // namespace
}  // namespace percuss
