#include "contact/joint/segment_rows.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "engine/contact/chain.hpp"
#include "engine/contact/solvers/random_system.hpp"

namespace percuss {
namespace {

using testing::append_chain;
using testing::Rng;

/// Two straight faces on each other, turned by an angle, with random nodes in between their common ends.
struct Faces {
    std::vector<Node> nodes;
    Surface fine, coarse;

    Faces(Rng& random, int fine_sides, int coarse_sides, double angle, double gap = 0) {
        const auto face = [&](int sides, double height, bool backwards) {
            std::vector<double> at{0, 10};
            for (int k = 1; k < sides; ++k) at.push_back(10 * (k + random.uniform(-0.4, 0.4)) / sides);
            std::sort(at.begin(), at.end());
            if (backwards) std::reverse(at.begin(), at.end());
            std::vector<std::array<double, 2>> points;
            for (const double s : at)
                points.push_back({s * std::cos(angle) - height * std::sin(angle),
                                  s * std::sin(angle) + height * std::cos(angle)});
            return append_chain(nodes, points, false);
        };
        fine = face(fine_sides, gap, false);     // its body above
        coarse = face(coarse_sides, 0.0, true);  // its body below
    }
    [[nodiscard]] SegmentRows builder(bool of_master = true) const {
        const auto masters = static_cast<std::int32_t>((of_master ? fine : coarse).nodes.size());
        return {NearSearch(fine, coarse,
                           {of_master, of_master ? 0 : masters, 100, SegmentRows::guard_slack, true}),
                NearSearch(coarse, fine,
                           {!of_master, of_master ? masters : 0, 100, SegmentRows::guard_slack, true}),
                false};
    }
    [[nodiscard]] ContactRows rows(SegmentRows builder, double range = 1e-3) const {
        ContactRows rows;
        builder.find({nodes.data(), 1e-3, range, 1}, rows);
        return rows;
    }
    [[nodiscard]] double half_length_beside(std::int32_t node) const {
        double sum = 0;
        for (const Surface* surface : {&fine, &coarse})
            for (const Side& side : surface->sides)
                if (side.i == node || side.j == node)
                    sum += 0.5 * std::hypot(nodes[static_cast<std::size_t>(side.i)].x[0] -
                                                nodes[static_cast<std::size_t>(side.j)].x[0],
                                            nodes[static_cast<std::size_t>(side.i)].x[1] -
                                                nodes[static_cast<std::size_t>(side.j)].x[1]);
        return sum;
    }
};

// Puso & Laursen: the forces of a uniform pressure on one face are those of a uniform pressure on the other.
TEST(SegmentRows, CarryUniformPressureFromFaceToFace) {
    Rng random(71);
    for (int round = 0; round < 50; ++round) {
        const double angle = random.uniform(0, 6.28);
        const Faces faces(random, 3 + random.index(9), 2 + random.index(9), angle);
        const ContactRows rows = faces.rows(faces.builder());
        ASSERT_EQ(rows.size(), faces.fine.nodes.size()) << "one for each fine node; no guard is near";
        std::map<std::int32_t, std::array<double, 2>> force;
        for (const ContactRow& row : rows) {
            const double pressed =
                faces.half_length_beside(faces.fine.nodes[static_cast<std::size_t>(row.owner)]);
            for (const RowTerm& term : rows.terms(row))
                for (std::size_t d = 0; d < 2; ++d) force[term.node][d] += pressed * term.g[d];
        }
        for (const Surface* surface : {&faces.fine, &faces.coarse}) {
            const double sign = surface == &faces.fine ? 1 : -1;
            for (const std::int32_t node : surface->nodes) {
                EXPECT_NEAR(force[node][0], -sign * faces.half_length_beside(node) * std::sin(angle), 1e-12);
                EXPECT_NEAR(force[node][1], sign * faces.half_length_beside(node) * std::cos(angle), 1e-12);
            }
        }
    }
}

TEST(SegmentRows, AreInEquilibriumAndMeasureTheGap) {
    Rng random(72);
    for (int round = 0; round < 50; ++round) {
        const double gap = random.uniform(0, 1e-3);
        const Faces faces(random, 3 + random.index(9), 2 + random.index(9), random.uniform(0, 6.28), gap);
        for (const bool of_master : {true, false}) {
            const ContactRows rows = faces.rows(faces.builder(of_master));
            ASSERT_FALSE(rows.empty());
            for (const ContactRow& row : rows) {
                double sum[2] = {0, 0}, first[2] = {0, 0}, moment = 0;
                std::int32_t k = 0;
                for (const RowTerm& term : rows.terms(row)) {
                    const double* x = faces.nodes[static_cast<std::size_t>(term.node)].x;
                    moment += x[0] * term.g[1] - x[1] * term.g[0];
                    for (std::size_t d = 0; d < 2; ++d) {
                        sum[d] += term.g[d];
                        if (k < row.master_terms) first[d] += term.g[d];
                    }
                    const auto& master = of_master ? faces.fine.nodes : faces.coarse.nodes;
                    EXPECT_EQ(std::find(master.begin(), master.end(), term.node) != master.end(),
                              k < row.master_terms);
                    ++k;
                }
                EXPECT_NEAR(std::hypot(sum[0], sum[1]), 0, 1e-14);
                EXPECT_NEAR(std::hypot(first[0], first[1]), 1, 1e-14)
                    << "a mean of unit normals, all alike here";
                EXPECT_NEAR(moment, 0, 1e-13);
                EXPECT_NEAR(row.penetration, -gap, 1e-14) << "at rest";
            }
        }
    }
}

// The mean gap of a corner over a side is wide; what keeps the corner out is its guard.
TEST(SegmentRows, GuardsHoldACorner) {
    std::vector<Node> nodes;
    const Surface floor = append_chain(nodes, {{4, 0}, {2, 0}, {0, 0}}, false);
    const Surface corner = append_chain(nodes, {{0.9, 1}, {1.5, 0}, {2.5, 1}}, false);
    for (const std::int32_t n : corner.nodes) nodes[static_cast<std::size_t>(n)].x[1] -= 0.018;
    for (const std::int32_t n : corner.nodes) nodes[static_cast<std::size_t>(n)].v[1] = -1;
    SegmentRows builder(NearSearch(floor, corner, {true, 0, 10, SegmentRows::guard_slack, true}),
                        NearSearch(corner, floor, {false, 3, 10, SegmentRows::guard_slack, true}), false);
    ContactRows rows;
    builder.find({nodes.data(), 0.015, 0.015, 1}, rows);
    ASSERT_EQ(rows.size(), 1U);
    EXPECT_EQ(rows[0].owner, 4);
    EXPECT_NEAR(builder.deepest(), 0.003, 1e-12);
    // 0.018 deep after the step, of which a hundredth of the mean side is let in.
    EXPECT_NEAR(rows[0].penetration, 0.018 - 0.01 * 0.5 * (std::hypot(0.6, 1) + std::hypot(1, 1)), 1e-12);
}

// One side over many: the coarse nodes find it, its own ends are far away.
TEST(SegmentRows, FindASideThatIsWiderThanTheOtherBody) {
    std::vector<Node> nodes;
    const Surface fine = append_chain(nodes, {{-50, 0.0}, {50, 0.0}}, false);
    std::vector<std::array<double, 2>> points;
    for (int k = 20; k >= 0; --k) points.push_back({0.1 * k, 0});
    const Surface coarse = append_chain(nodes, points, false);
    SegmentRows builder(NearSearch(fine, coarse, {true, 0, 30, SegmentRows::guard_slack, true}),
                        NearSearch(coarse, fine, {false, 2, 30, SegmentRows::guard_slack, true}), false);
    ContactRows rows;
    builder.find({nodes.data(), 1e-3, 1e-4, 1}, rows);
    ASSERT_EQ(rows.size(), 2U);
    for (const ContactRow& row : rows) {
        double on_fine = 0, on_coarse = 0;
        for (const RowTerm& term : rows.terms(row)) (term.node < 2 ? on_fine : on_coarse) += term.g[1];
        EXPECT_NEAR(on_fine, 1, 1e-14);
        EXPECT_NEAR(on_coarse, -1, 1e-13);
    }
}

}  // namespace
}  // namespace percuss
