#include "mesh/overlap.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "mesh/segment_tree.hpp"

namespace percuss {
namespace {

/// A body that is only its outline: find_overlap looks at nothing else.
MeshBody outline(Mesh& mesh, const std::string& name, const std::vector<Vec2>& points) {
    MeshBody body;
    body.name = name;
    body.outlines = {{"outline", {}, true}};
    for (const auto& point : points) {
        body.outlines[0].nodes.push_back(mesh.node_count());
        mesh.nodes.push_back(point);
    }
    return body;
}

std::vector<Vec2> rectangle(double x, double y, double w, double h) {
    return {{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}};
}

double depth(const std::vector<Vec2>& master, const std::vector<Vec2>& slave, bool axisymmetric = false) {
    Mesh mesh;
    const auto a = outline(mesh, "a", master), b = outline(mesh, "b", slave);
    const auto overlap = find_overlap(mesh, a, "", b, axisymmetric, 1e-9);
    return overlap ? overlap->depth : 0;
}

TEST(FindOverlap, TouchingIsNone) {
    const auto base = rectangle(0, 0, 2, 1);
    EXPECT_EQ(depth(rectangle(0, 1, 2, 1), base), 0);    // face on face, corner on corner
    EXPECT_EQ(depth(rectangle(0.5, 1, 1, 1), base), 0);  // inside the face
    EXPECT_EQ(depth(rectangle(2, 0.25, 1, 0.5), base), 0);
    EXPECT_EQ(depth(rectangle(2, 1, 1, 1), base), 0);  // corner to corner
    EXPECT_EQ(depth(rectangle(0, 3, 2, 1), base), 0);
}

TEST(FindOverlap, MeasuresTheWayOut) {
    const auto base = rectangle(0, 0, 2, 1);
    EXPECT_NEAR(depth(rectangle(0.5, 0.9, 1, 1), base), 0.1, 1e-12);
    EXPECT_NEAR(depth(rectangle(0, 0.9, 2, 1), base), 0.1, 1e-12);  // flush sides: corners on the surface
    EXPECT_NEAR(depth(rectangle(0, 0.9, 2, 1), base, true), 0.1, 1e-12);    // and one of them on the axis
    EXPECT_NEAR(depth(rectangle(0.5, 1 - 1e-6, 1, 1), base), 1e-6, 1e-12);  // small against the cells
    EXPECT_EQ(depth(rectangle(0.5, 1 - 1e-10, 1, 1), base), 0);             // below the tolerance
}

std::vector<Vec2> circle(std::size_t count, double radius, const Vec2& centre) {
    std::vector<Vec2> points;
    for (std::size_t i = 0; i < count; ++i) {
        const double angle = 2 * M_PI * static_cast<double>(i) / static_cast<double>(count);
        points.push_back(centre + radius * Vec2(std::cos(angle), std::sin(angle)));
    }
    return points;
}

TEST(FindOverlap, OfTenThousandNodesTakesNoTime) {
    EXPECT_EQ(depth(circle(10'000, 1, {2.001, 0}), circle(10'000, 1, {0, 0})), 0);
    EXPECT_NEAR(depth(circle(10'000, 1, {1.9, 0}), circle(10'000, 1, {0, 0})), 0.1, 1e-6);
    EXPECT_NEAR(depth(circle(10'000, 0.5, {0, 0}), circle(10'000, 1, {0, 0})), 0.5, 1e-6);
}

TEST(SegmentTree, AgreesWithASearchOfAllSegments) {
    const auto points = circle(500, 1, {0, 0});
    std::vector<Segment> segments;
    for (std::size_t i = 0; i < points.size(); ++i)
        segments.push_back({points[i], points[(i + 1) % points.size()]});
    const SegmentTree tree(segments);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> number(-1.5, 1.5);
    for (int i = 0; i < 2000; ++i) {
        const Vec2 point{number(random), number(random)};
        double least = 1e9;
        for (const auto& [from, to] : segments) {
            const double s = std::clamp((point - from).dot(to - from) / (to - from).squaredNorm(), 0.0, 1.0);
            least = std::min(least, (from + s * (to - from) - point).norm());
        }
        const auto nearest = tree.nearest(point, [](std::size_t) { return true; });
        ASSERT_TRUE(nearest);
        EXPECT_EQ(nearest->distance, least);
        EXPECT_EQ(tree.winding(point), point.norm() < std::cos(M_PI / 500) ? 1 : 0);
    }
}

}  // namespace
}  // namespace percuss
