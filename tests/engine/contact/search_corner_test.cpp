#include <cmath>
#include <limits>
#include <optional>

#include <gtest/gtest.h>

#include "contact/search.hpp"
#include "engine/contact/chain.hpp"
#include "engine/contact/node_row.hpp"

namespace percuss {
namespace {

using testing::NodeRow;

using Points = std::vector<std::array<double, 2>>;

/// One master node that moves over a resting slave surface, one step a call.
class SearchCorner : public ::testing::Test {
  protected:
    void slave(const Points& points, bool closed) {
        nodes_.assign(1, Node{});
        Surface surface = testing::append_chain(nodes_, points, closed);
        search_.emplace(Surface{{}, {0}}, surface);
    }
    /// A block of 4 x 2 sides of length 1 whose top is y = 0, walked with the body on the left from (0, -2).
    void block() {
        slave({{0, -2},
               {1, -2},
               {2, -2},
               {3, -2},
               {4, -2},
               {4, -1},
               {4, 0},
               {3, 0},
               {2, 0},
               {1, 0},
               {0, 0},
               {0, -1}},
              true);
    }
    /// The top alone.
    void open_face() { slave({{4, 0}, {3, 0}, {2, 0}, {1, 0}, {0, 0}}, false); }

    const std::vector<NodeRow>& move(double from_x, double from_y, double to_x, double to_y) {
        nodes_[0] = {{to_x, to_y}, {(to_x - from_x) / dt, (to_y - from_y) / dt}};
        ContactRows rows;
        search_->find(nodes_.data(), dt, rows);
        rows_ = testing::node_rows(rows.all());
        return rows_;
    }
    /// A row on the given side with this normal and depth, its force shared at (x, y).
    void expect_row(double nx, double ny, double depth, double x, double y) {
        ASSERT_EQ(rows_.size(), 1U);
        const NodeRow& row = rows_[0];
        EXPECT_NEAR(row.normal[0], nx, 1e-12);
        EXPECT_NEAR(row.normal[1], ny, 1e-12);
        EXPECT_NEAR(row.penetration, depth, 1e-12);
        double foot[2] = {0, 0};
        for (std::size_t k = 1; k < 3; ++k)
            for (std::size_t d = 0; d < 2; ++d)
                foot[d] -= row.share[k] * nodes_[static_cast<std::size_t>(row.node[k])].x[d];
        EXPECT_NEAR(foot[0], x, 1e-12);
        EXPECT_NEAR(foot[1], y, 1e-12);
        EXPECT_EQ(row.share[0], 1);
        EXPECT_NEAR(row.share[1] + row.share[2], -1, 1e-15) << "equilibrium";
    }

    static constexpr double dt = 0.1;
    std::vector<Node> nodes_;
    std::optional<PenetrationSearch> search_;
    std::vector<NodeRow> rows_;
};

TEST_F(SearchCorner, OneSideHoldsANodeBetweenItsEnds) {
    open_face();
    EXPECT_TRUE(move(2.3, 0.02, 2.3, 0.01).empty());
    move(2.3, 0.01, 2.3, -0.03);
    expect_row(0, 1, 0.03, 2.3, 0);
    EXPECT_EQ(rows_[0].node, (std::array<std::int32_t, 3>{0, 2, 3}));
    EXPECT_NEAR(rows_[0].share[2], -0.7, 1e-12) << "a runs from the side's first node";
}

// Either orientation: the body is on the left of the chain, so the reversed chain is pierced from below.
TEST_F(SearchCorner, OrientationTellsTheInside) {
    slave({{0, 0}, {1, 0}, {2, 0}}, false);
    EXPECT_TRUE(move(0.5, 0.01, 0.5, -0.03).empty());
    slave({{0, 0}, {1, 0}, {2, 0}}, false);
    move(0.5, -0.03, 0.5, 0.01);
    expect_row(0, -1, 0.01, 0.5, 0);
}

TEST_F(SearchCorner, NodePastTheOpenEndFallsFree) {
    open_face();
    EXPECT_TRUE(move(4.5, 0.01, 4.5, -0.03).empty());
    EXPECT_TRUE(move(4.5, -0.03, 4.03, -0.04).empty());
    EXPECT_TRUE(move(4.03, -0.04, 3.9, -0.3).empty()) << "slid under the end: not thrown out";
}

TEST_F(SearchCorner, FlushEndNodeBelongsToTheFace) {
    for (const bool closed : {false, true}) {
        for (const double past : {-1e-9, 0.0, 1e-9, 0.015}) {
            closed ? block() : open_face();
            EXPECT_TRUE(move(4 + past, 0.01, 4 + past, 1e-4).empty());
            move(4 + past, 1e-4, 4 + past, -0.004);
            ASSERT_EQ(rows_.size(), 1U) << closed << " " << past;
            expect_row(0, 1, 0.004, std::min(4 + past, 4.0), 0);
            // Held there, it stays with the face whatever the sideways motion.
            move(4 + past, 0, 4 - 1e-6, -0.005);
            expect_row(0, 1, 0.005, 4 - 1e-6, 0);
            move(4 - 1e-6, 0, 4 + 1e-6, -0.005);
            expect_row(0, 1, 0.005, 4, 0);
        }
    }
}

TEST_F(SearchCorner, NodeLetGoBesideACornerIsNotCaughtByTheOtherFace) {
    block();
    move(4.01, -0.3, 3.99, -0.3);  // through the side wall
    expect_row(1, 0, 0.01, 4, -0.3);
    EXPECT_TRUE(move(4, -0.3, 4.001, -0.3).empty());
    EXPECT_TRUE(move(4.001, -0.3, 4.001, -0.31).empty());
}

TEST_F(SearchCorner, ConvexCornerPushesBackThroughTheFaceItCameThrough) {
    // 0.05 below the top and 0.01 from the side wall, which is nearer but was not passed.
    block();
    move(3.99, 0.02, 3.99, -0.05);
    expect_row(0, 1, 0.05, 3.99, 0);
    // The same place through the wall, which is nearer; then deeper than the top is far.
    block();
    move(4.02, -0.05, 3.99, -0.05);
    expect_row(1, 0, 0.01, 4, -0.05);
    block();
    move(4.02, -0.01, 3.95, -0.01);
    expect_row(1, 0, 0.05, 4, -0.01);
}

TEST_F(SearchCorner, CornerPassedDiagonallyHoldsWhereTheNodeMovesIn) {
    block();
    move(4 + 1e-9, 0.02, 4 - 1e-9, -0.005);
    expect_row(0, 1, 0.005, 4 - 1e-9, 0);
    block();
    move(4.02, 1e-9, 3.995, -1e-9);
    expect_row(1, 0, 0.005, 4, -1e-9);
}

TEST_F(SearchCorner, NothingOutsideAConvexVertex) {
    block();
    EXPECT_TRUE(move(4.5, 0.5, 4.03, 0.01).empty());
    // An obtuse vertex of a round body: outside is outside, however near.
    slave({{0, -2}, {2, -1}, {2, 0}, {1, 0.2}, {0, 0.2}, {-1, 0}}, true);
    EXPECT_TRUE(move(1 - 0.015, 0.25, 1 - 0.015, 0.2 + 1e-5).empty());
    move(1 - 0.015, 0.2 + 1e-5, 1 - 0.015, 0.2 - 1e-3);
    expect_row(0, 1, 1e-3, 1 - 0.015, 0.2);
}

TEST_F(SearchCorner, NotchPushesTowardsItsVertex) {
    // The body lies below a V whose lowest point is (0, 0).
    slave({{2, 1}, {1, 0.5}, {0, 0}, {-1, 0.5}, {-2, 1}}, false);
    EXPECT_TRUE(move(0, 0.05, 0.001, 0.01).empty());
    move(0.001, 0.01, 0.003, -0.04);
    const double depth = std::hypot(0.003, 0.04);
    expect_row(-0.003 / depth, 0.04 / depth, depth, 0, 0);
    // Beside the vertex the nearer flank holds it along its own normal.
    slave({{2, 1}, {1, 0.5}, {0, 0}, {-1, 0.5}, {-2, 1}}, false);
    move(0.5, 0.3, 0.5, 0.22);
    const double n = std::hypot(1, 0.5);
    expect_row(-0.5 / n, 1 / n, 0.03 / n, 0.5 - 0.03 / n * 0.5 / n, 0.22 + 0.03 / n / n);
}

TEST_F(SearchCorner, NodesUnderAVertexOfAStraightChainAreHeld) {
    for (const double offset : {-1e-16, 0.0, 1e-16, 1e-9, -1e-9}) {
        open_face();
        move(2 + offset, 0.01, 2 + offset, -0.01);
        expect_row(0, 1, 0.01, 2 + offset, 0);
    }
}

// A plate of 0.3 whose top alone is the slave surface: its lower neighbour's nodes are behind the face, not
// in it.
TEST_F(SearchCorner, FarSideOfAThinBodyIsNoContact) {
    open_face();
    for (int step = 0; step < 200; ++step) {
        const double y = -0.3 - 0.01 * std::cos(0.1 * step);
        EXPECT_TRUE(move(2.4, y, 2.4, y + 1e-4).empty());
    }
    for (double y = -0.3; y < -0.02; y += 0.01)
        EXPECT_TRUE(move(2.4, y - 0.01, 2.4, y).empty())
            << "moved up inside: it did not come through the top";
}

TEST_F(SearchCorner, AHeldNodeIsNotLostWhenItStaysInside) {
    // What another pair does may leave it inside: it is still held, without any motion of its own.
    open_face();
    move(2.4, 0.01, 2.4, -0.1);
    ASSERT_EQ(rows_.size(), 1U);
    move(2.4, -0.1, 2.4, -0.1);
    expect_row(0, 1, 0.1, 2.4, 0);
    move(2.4, -0.1, 2.4, -0.6);
    EXPECT_TRUE(move(2.4, -0.6, 2.4, -0.6).empty()) << "deeper than half a side nothing can hold it";
}

TEST_F(SearchCorner, ThreeFacesOfAClosedOutlineHold) {
    block();
    move(-0.01, -0.5, 0.02, -0.5);
    expect_row(-1, 0, 0.02, 0, -0.5);
    block();
    move(2.5, -2.01, 2.5, -1.97);
    expect_row(0, -1, 0.03, 2.5, -2);
    block();
    move(0.2, 0.01, 0.2, -0.02);
    expect_row(0, 1, 0.02, 0.2, 0);
}

// A diverging run brings numbers that are none; the search must survive them to let the run end with a
// message.
TEST_F(SearchCorner, SurvivesPositionsThatAreNotFinite) {
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        open_face();
        EXPECT_TRUE(move(2.4, 0.2, bad, 0.1).empty());
        EXPECT_TRUE(move(2.4, 0.2, 2.4, -0.1).empty() || rows_.size() == 1);
        open_face();
        for (std::size_t n = 1; n < nodes_.size(); ++n) nodes_[n].x[1] = bad;
        EXPECT_TRUE(move(2.4, 0.2, 2.4, 0.1).empty());
        search_->forget();
        for (std::size_t n = 1; n < nodes_.size(); ++n) nodes_[n].x[1] = 0;
        EXPECT_TRUE(move(2.4, 0.2, 2.4, 0.1).empty());
        EXPECT_EQ(move(2.4, 0.1, 2.4, -0.1).size(), 1U) << "forgets the diverged state";
    }
}

}  // namespace
}  // namespace percuss
