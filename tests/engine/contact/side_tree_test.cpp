#include "contact/side_tree.hpp"

#include <limits>

#include <gtest/gtest.h>

#include "engine/contact/chain.hpp"
#include "engine/contact/solvers/random_system.hpp"

namespace percuss {
namespace {

using testing::distance_to_segment;
using testing::Rng;

TEST(SideTree, FindsTheNearestSideOfBentChainsWithOutdatedBoxes) {
    Rng random(8);
    for (int round = 0; round < 300; ++round) {
        std::vector<Node> nodes;
        const int count = 3 + random.index(60);
        std::vector<std::array<double, 2>> points;
        std::array<double, 2> at{0, 0};
        for (int k = 0; k < count; ++k) {
            points.push_back(at);
            at = {at[0] + random.uniform(-0.3, 1), at[1] + random.uniform(-1, 1)};
        }
        const Surface surface = testing::append_chain(nodes, points, round % 2 == 0);
        SideTree tree(surface.sides.size());
        tree.fit(nodes.data(), surface.sides);
        const double moved = round % 3 == 0 ? 0 : random.uniform(0, 3);
        const double angle = random.uniform(0, 6.28);
        for (Node& node : nodes) {
            node.x[0] += moved * std::cos(angle);
            node.x[1] += moved * std::sin(angle);
        }
        for (int query = 0; query < 30; ++query) {
            const double x = random.uniform(-5, 25), y = random.uniform(-10, 10);
            std::array<std::int32_t, 3> except{-1, -1, -1};
            for (std::int32_t& side : except)
                if (query % 2) side = random.index(static_cast<int>(surface.sides.size()));
            double expected = std::numeric_limits<double>::infinity();
            for (std::int32_t s = 0; s < static_cast<std::int32_t>(surface.sides.size()); ++s) {
                if (std::find(except.begin(), except.end(), s) != except.end()) continue;
                const Side& side = surface.sides[static_cast<std::size_t>(s)];
                expected =
                    std::min(expected, distance_to_segment(nodes[static_cast<std::size_t>(side.i)].x,
                                                           nodes[static_cast<std::size_t>(side.j)].x, x, y));
            }
            const auto found = tree.nearest(nodes.data(), surface.sides, x, y, moved, SidesOtherThan{except});
            if (!std::isfinite(expected)) {
                EXPECT_EQ(found.side, -1);
                continue;
            }
            ASSERT_NEAR(found.distance, expected, 1e-12) << "round " << round;
            ASSERT_EQ(std::count(except.begin(), except.end(), found.side), 0);
        }
    }
}

}  // namespace
}  // namespace percuss
