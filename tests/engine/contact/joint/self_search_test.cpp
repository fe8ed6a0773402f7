// A surface against itself: which of its sides a node faces.
#include <cmath>

#include <gtest/gtest.h>

#include "contact/joint/near_search.hpp"
#include "engine/contact/chain.hpp"
#include "engine/contact/node_row.hpp"

namespace percuss {
namespace {

using testing::append_chain;
using testing::node_rows;
using testing::NodeRow;

/// The rows of a closed outline whose nodes all move by less than `range` in the step.
std::vector<NodeRow> rows_of(const std::vector<std::array<double, 2>>& points, double range = 0.02) {
    std::vector<Node> nodes;
    const Surface outline = append_chain(nodes, points, true);
    ContactRows rows;
    NearSearch(outline, outline, {.by_facing = true, .self = true}).find({nodes.data(), 1, range, 1}, rows);
    return node_rows(rows.all());
}

/// Points along straight lines between corners, about 1 apart; the body on the left.
std::vector<std::array<double, 2>> outline(const std::vector<std::array<double, 2>>& corners) {
    std::vector<std::array<double, 2>> points;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const auto &a = corners[k], &b = corners[(k + 1) % corners.size()];
        const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
        const int parts = std::max(1, static_cast<int>(std::lround(length)));
        for (int p = 0; p < parts; ++p)
            points.push_back({a[0] + (b[0] - a[0]) * p / parts, a[1] + (b[1] - a[1]) * p / parts});
    }
    return points;
}

/// A U with arms 3 wide and 10 high, the slot between them `slot` wide.
std::vector<std::array<double, 2>> u(double slot) {
    const double s = 0.5 * slot;
    return outline({{-3 - s, 0}, {3 + s, 0}, {3 + s, 10}, {s, 10}, {s, 3}, {-s, 3}, {-s, 10}, {-3 - s, 10}});
}

TEST(SelfSearch, FindsNothingInOutlinesThatDoNotFold) {
    EXPECT_TRUE(rows_of(outline({{0, 0}, {10, 0}, {10, 4}, {0, 4}})).empty());
    EXPECT_TRUE(rows_of(outline({{0, 0}, {10, 0}, {10, 0.05}, {0, 0.05}})).empty())
        << "the back of a thin plate is no contact";
    EXPECT_TRUE(rows_of(outline({{0, 0}, {10, -0.5}, {10, 0.5}})).empty()) << "nor the sides of a wedge";
    EXPECT_TRUE(rows_of(outline({{0, 0}, {5, 2}, {10, 0}, {10, 8}, {0, 8}})).empty()) << "a valley";
    EXPECT_TRUE(rows_of(u(1)).empty());
}

TEST(SelfSearch, FindsTheTwoFacesOfASlotThatIsNearlyClosed) {
    const auto rows = rows_of(u(0.01));
    ASSERT_FALSE(rows.empty());
    for (const NodeRow& row : rows) {
        EXPECT_NEAR(std::abs(row.normal[0]), 1, 1e-12);
        EXPECT_NEAR(row.penetration, -0.01, 1e-12) << "the slot's width";
    }
    // Six nodes inside each face and its mouth; those at the bottom are kept apart by their own material.
    EXPECT_GE(rows.size(), 12U);
    EXPECT_LE(rows.size(), 16U);
}

TEST(SelfSearch, SeesATipComingAtAFaceHeadOn) {
    // A hook whose wedge-shaped tip, of 20 degrees, points down at the inside of its foot.
    const double tip = 1.01;
    const auto hook = outline(
        {{0, 0}, {12, 0}, {12, 1}, {1, 1}, {1, 9}, {6.3, 9}, {7, tip}, {7.7, 9}, {9, 9}, {9, 12}, {0, 12}});
    const auto rows = rows_of(hook);
    ASSERT_EQ(rows.size(), 1U);
    EXPECT_NEAR(rows[0].normal[1], 1, 1e-12);
    EXPECT_NEAR(rows[0].penetration, -0.01, 1e-12);
}

TEST(SelfSearch, HoldsANodeThatIsInByLessThanItMoved) {
    EXPECT_FALSE(rows_of(u(-0.015)).empty()) << "went past each other by less than a step's motion";
    EXPECT_TRUE(rows_of(u(-0.3)).empty()) << "did not come there through the face";
}

// As springs let it.
TEST(SelfSearch, HoldsANodeThatTouchedHoweverDeepItIsByNow) {
    std::vector<Node> nodes;
    const Surface surface = append_chain(nodes, u(0.005), true);
    NearSearch search(surface, surface, {.by_facing = true, .self = true});
    ContactRows touching, deep;
    search.find({nodes.data(), 1, 0.02, 1}, touching);
    search.advance(0.06, 0.06);
    const auto closed = u(-0.05);
    ASSERT_EQ(closed.size(), nodes.size());
    for (std::size_t k = 0; k < nodes.size(); ++k) nodes[k].x[0] = closed[k][0];
    search.find({nodes.data(), 1, 1e-3, 1}, deep);
    EXPECT_GE(touching.size(), 12U);
    EXPECT_GE(deep.size(), 12U);
    for (const ContactRow& row : deep) EXPECT_NEAR(row.penetration, 0.05, 1e-12);
    EXPECT_TRUE(rows_of(closed, 1e-3).empty()) << "which did not come there through the face";
}

// A fold that closes step by step: rows appear in the step that could close it, and name the same sides as a
// search that begins there.
TEST(SelfSearch, RemembersWhatANewSearchWouldFind) {
    std::vector<Node> nodes;
    const auto points = u(1);
    const Surface surface = append_chain(nodes, points, true);
    NearSearch search(surface, surface, {.by_facing = true, .self = true});
    const double speed = 0.013;
    int found = 0;
    for (int step = 0; step < 38; ++step) {
        for (std::size_t k = 0; k < nodes.size(); ++k) {
            Node& node = nodes[k];
            // Arms lean in; the foot stays.
            const double lean = std::max(0.0, points[k][1] - 3) / 7;
            node.v[0] = points[k][0] > 0 ? -speed * lean : speed * lean;
            node.x[0] += node.v[0];
        }
        ContactRows rows, anew;
        const double range = 2 * speed;
        search.find({nodes.data(), 1, range, 1}, rows);
        search.advance(range, speed);
        NearSearch(surface, surface, {.by_facing = true, .self = true})
            .find({nodes.data(), 1, range, 1}, anew);
        const auto a = node_rows(rows.all()), b = node_rows(anew.all());
        ASSERT_EQ(a.size(), b.size()) << step;
        for (std::size_t k = 0; k < a.size(); ++k) {
            EXPECT_EQ(a[k].side, b[k].side);
            EXPECT_EQ(a[k].penetration, b[k].penetration);
        }
        found += a.empty() ? 0 : 1;
    }
    EXPECT_GT(found, 0);
    EXPECT_LT(found, 6) << "it meets in the end only";
}

// Two prongs that hang over a foot pass by: a node that has seen the first sees the second, too, which was
// out of its sight at first.
TEST(SelfSearch, SeesWhatComesAfterWhatItHasSeen) {
    std::vector<Node> nodes;
    const auto points = outline({{0, 0},
                                 {30, 0},
                                 {30, 1},
                                 {1, 1},
                                 {1, 9},
                                 {5, 9},
                                 {5, 1.1},
                                 {6, 1.1},
                                 {6, 9},
                                 {9, 9},
                                 {9, 1.1},
                                 {10, 1.1},
                                 {10, 9},
                                 {13, 9},
                                 {13, 12},
                                 {0, 12}});
    const Surface surface = append_chain(nodes, points, true);
    NearSearch search(surface, surface, {.by_facing = true, .self = true});
    const double speed = 0.053, range = 2 * speed;
    for (int step = 0; step < 90; ++step) {
        for (std::size_t k = 0; k < nodes.size(); ++k) {
            const bool hangs = points[k][0] > 4 && points[k][0] < 11 && points[k][1] > 1 && points[k][1] < 9;
            nodes[k].v[0] = hangs ? speed * (9 - points[k][1]) / 7.9 : 0;
            nodes[k].x[0] += nodes[k].v[0];
        }
        ContactRows rows, anew;
        search.find({nodes.data(), 1, range, 1}, rows);
        search.advance(range, speed);
        NearSearch(surface, surface, {.by_facing = true, .self = true})
            .find({nodes.data(), 1, range, 1}, anew);
        const auto a = node_rows(rows.all()), b = node_rows(anew.all());
        ASSERT_GE(b.size(), 4U) << "two corners, and the nodes of the foot below";
        ASSERT_EQ(a.size(), b.size()) << step;
        for (std::size_t k = 0; k < a.size(); ++k) EXPECT_EQ(a[k].side, b[k].side) << step;
    }
}

}  // namespace
}  // namespace percuss
