// Bodies that fold on themselves.
#include <algorithm>
#include <cmath>

#include "verification/schemes.hpp"

namespace percuss::testing {
namespace {

std::string fold(const std::string& body, const std::string& more = "") {
    return fmt::format("[[contact]]\nname = \"fold\"\nbodies = [\"{0}\", \"{0}\"]\n{1}", body, more);
}

std::string block(std::array<double, 4> box, std::array<int, 2> divisions, const std::string& names = "") {
    return fmt::format(
        "[[body.block]]\ncorners = [[{0:.17g}, {1:.17g}], [{2:.17g}, {1:.17g}], [{2:.17g}, {3:.17g}], "
        "[{0:.17g}, {3:.17g}]]\ndivisions = [{4}, {5}]\n{6}\n",
        box[0], box[1], box[2], box[3], divisions[0], divisions[1], names);
}

constexpr double slot = 0.2;

/// The right half of a U, or all of it: a foot and arms with pads at their tops, whose faces come together
/// when a pulse of pressure bends the arms in.
std::string u_of_halves(bool whole) {
    const double s = 0.5 * slot;
    std::string text = "[[body]]\nname = \"u\"\nmaterial = \"steel\"\n";
    text += block({0, 0, s, 3}, {1, 3}, whole ? "" : "names = { left = \"cut\" }");
    text +=
        block({s, 0, s + 3, 3}, {3, 3}) + block({s, 3, s + 3, 20}, {3, 17}, "names = { right = \"right\", left = \"face\" }");
    if (whole)
        text += block({-s, 0, 0, 3}, {1, 3}) + block({-s - 3, 0, -s, 3}, {3, 3}) +
                block({-s - 3, 3, -s, 20}, {3, 17}, "names = { left = \"left\" }");
    const std::string pulse = "pressure = [[0, 0.1], [0.05, 0.1], [0.06, 0]]\n";
    text += "[[body.load]]\nedge = \"right\"\n" + pulse;
    if (whole)
        text += "[[body.load]]\nedge = \"left\"\n" + pulse;
    else
        text += "[[body.constraint]]\nedge = \"cut\"\nfixed = [\"x\"]\n";
    return text;
}

// By symmetry the middle of a slot is a wall that does not move. The whole has each condition twice, with the
// normal of a face that turns instead of the wall's: arms that lean by some 0.01 press by as much less along
// x.
TEST(SelfContact, ASlotClosesAsHalfOfItOnAWall) {
    const std::string head = scene_head("plane strain", 0.15, 0.3);
    RecordedRun whole(scene_of(head + u_of_halves(true) + fold("u")));
    RecordedRun half(scene_of(head + u_of_halves(false) +
                              "[[wall]]\nname = \"middle\"\npoint = [0, 0]\nnormal = [1, 0]\n"
                              "[[contact]]\nname = \"fold\"\nmaster = \"u.face\"\nslave = \"middle\"\n" +
                              joint_problem));
    whole.to_end();
    half.to_end();
    const RunStatistics a = whole.solver.statistics(), b = half.solver.statistics();
    ASSERT_GT(b.pairs[0].impulse[0], 0);
    EXPECT_NEAR(a.pairs[0].impulse[0], b.pairs[0].impulse[0], 0.01 * b.pairs[0].impulse[0]);
    EXPECT_LT(momentum_error(a), 1e-12);
    EXPECT_LT(whole.unexplained_energy(), 1e-9 * std::abs(whole.column("energy.external").back()));
    EXPECT_LT(a.pairs[0].max_penetration, 1e-4);
    EXPECT_EQ(a.contact_solver.fallbacks, 0);
}

/// A bar flies at a wall.
std::string flyer() {
    return scene_head("plane strain", 0.03, 0.3) +
           box_body("bar", {0, 0.01, 2, 4.01}, {4, 40}, "velocity = [3, -40]") +
           "[[wall]]\nname = \"floor\"\npoint = [0, 0]\nnormal = [0, 1]\n" + joint_problem +
           bodies_pair("hit", "bar", "floor", "symmetric");
}

TEST(SelfContact, DoesNothingToABodyThatDoesNotFold) {
    RecordedRun with(scene_of(flyer() + fold("bar"))), without(scene_of(flyer()));
    with.to_end();
    without.to_end();
    EXPECT_EQ(with.solver.statistics().pairs[1].events, 0);
    ASSERT_EQ(with.solver.nodes().size(), without.solver.nodes().size());
    for (std::size_t n = 0; n < with.solver.nodes().size(); ++n)
        for (std::size_t d = 0; d < 2; ++d)
            ASSERT_EQ(with.solver.nodes()[n].x[d], without.solver.nodes()[n].x[d]) << "bit by bit";
}

/// A tube between two plates that come together until its inside meets itself.
std::string tube(const std::string& contact) {
    std::string text = scene_head("plane strain", 0.3, 0.3, "courant = 0.9",
                                  "viscosity = { linear = 0.06, quadratic = 1.2 }\nplastic = { yield = 0.3, "
                                  "linear = 0.5 }");
    text += "[[body]]\nname = \"tube\"\nmaterial = \"steel\"\n";
    const std::array<std::array<double, 2>, 5> at{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 0}}};
    for (std::size_t k = 0; k < 4; ++k) {
        const auto &a = at[k], &b = at[k + 1];
        const double x = std::sqrt(0.5) * (a[0] + b[0]), y = std::sqrt(0.5) * (a[1] + b[1]);
        text += fmt::format(
            "[[body.block]]\ncorners = [[{:.17g}, {:.17g}], [{:.17g}, {:.17g}], [{:.17g}, {:.17g}], "
            "[{:.17g}, {:.17g}]]\ndivisions = [2, 12]\nedges = {{ right = {{ arc = [{:.17g}, {:.17g}] "
            "}}, left = {{ arc = [{:.17g}, {:.17g}] }} }}\n",
            5 * a[0], 5 * a[1], 6 * a[0], 6 * a[1], 6 * b[0], 6 * b[1], 5 * b[0], 5 * b[1], 6 * x, 6 * y,
            5 * x, 5 * y);
    }
    return text + box_body("upper", {-8, 6.01, 8, 26.01}, {9, 8}, "velocity = [0, -60]") +
           box_body("lower", {-8, -26.01, 8, -6.01}, {9, 8}, "velocity = [0, 60]") + contact;
}

TEST(SelfContact, HoldsATubeThatIsCrushedFlat) {
    for (const char* contact : {"[[contact]]\nname = \"any\"\nbodies = \"all\"\n",
                                "[[contact]]\nname = \"any\"\nbodies = \"all\"\nfriction = "
                                "0.2\n"}) {
        const Scene scene = scene_of(tube(contact));
        RecordedRun run(scene);
        run.to_end();
        const RunStatistics s = run.solver.statistics();
        const auto self = std::find_if(scene.contacts.begin(), scene.contacts.end(),
                                       [](const ContactPair& pair) { return pair.name == "any-tube-tube"; });
        const PairStatistics& pair = s.pairs[static_cast<std::size_t>(self - scene.contacts.begin())];
        EXPECT_GT(pair.events, 0);
        EXPECT_GT(pair.impulse[1], 0);
        EXPECT_LT(pair.max_penetration, 1e-3);
        EXPECT_LT(s.maximum_growth, 1e-5);
        EXPECT_LT(momentum_error(s), 1e-12);
        EXPECT_LT(run.unexplained_energy(), 1e-9 * s.initial_energy);
        // Top and bottom of the inside have not passed each other.
        double top = -1e9, bottom = 1e9;
        const Mesh& mesh = run.solver.setup()->mesh;
        for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
            if (std::abs(mesh.nodes[n].norm() - 5) > 1e-6 || std::abs(mesh.nodes[n].x()) > 1e-6) continue;
            (mesh.nodes[n].y() > 0 ? top : bottom) = run.solver.nodes()[n].x[1];
        }
        EXPECT_GT(top, bottom - 1e-3);
    }
}

}  // namespace
}  // namespace percuss::testing
