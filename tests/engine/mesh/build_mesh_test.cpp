#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "engine/scene/small_scene.hpp"
#include "mesh/curve.hpp"
#include "mesh/select.hpp"

namespace percuss::testing {
namespace {

constexpr double pi = std::numbers::pi;

/// A plane scene of one body with the given blocks (and lines of [[body]] before them).
Mesh mesh_of(const std::string& body) {
    const std::string head =
        changed(small_scene.substr(0, small_scene.find("[[body]]")), "axisymmetric", "plane strain");
    const auto scene =
        parse_scene(head + "[[body]]\nname = \"b\"\nmaterial = \"steel\"\n" + body, "scene.toml");
    return build_mesh(scene);
}

std::string fault(const std::string& body) {
    try {
        static_cast<void>(mesh_of(body));
    } catch (const SceneError& error) {
        return error.what();
    }
    return "";
}

std::string block(const std::string& corners, const std::string& rest) {
    return "[[body.block]]\ncorners = " + corners + "\n" + rest + "\n";
}

Vec2 at(const Mesh& mesh, std::int32_t node) { return mesh.nodes[static_cast<std::size_t>(node)]; }

double area(const Mesh& mesh) {
    double sum = 0;
    for (const auto& cell : mesh.cells) {
        const auto count = static_cast<std::size_t>(corner_count(cell));
        for (std::size_t i = 0; i < count; ++i) {
            const Vec2 a = at(mesh, cell[i]), b = at(mesh, cell[(i + 1) % count]);
            sum += (a.x() * b.y() - a.y() * b.x()) / 2;
        }
    }
    return sum;
}

const Edge& edge(const Mesh& mesh, const std::string& name) { return *find_edge(mesh.bodies.at(0), name); }

TEST(BuildMesh, OfOneBlockHasItsSidesAsEdgesWithTheBodyOnTheLeft) {
    const auto mesh = mesh_of(block("[[0, 0], [4, 0], [4, 2], [0, 2]]", "divisions = [4, 2]"));
    EXPECT_EQ(mesh.node_count(), 15);
    EXPECT_EQ(mesh.cell_count(), 8);
    EXPECT_DOUBLE_EQ(area(mesh), 8);
    const auto ends = [&](const std::string& name) {
        return std::pair(at(mesh, edge(mesh, name).nodes.front()), at(mesh, edge(mesh, name).nodes.back()));
    };
    EXPECT_EQ(ends("bottom"), std::pair(Vec2(0, 0), Vec2(4, 0)));
    EXPECT_EQ(ends("right"), std::pair(Vec2(4, 0), Vec2(4, 2)));
    EXPECT_EQ(ends("top"), std::pair(Vec2(4, 2), Vec2(0, 2)));
    EXPECT_EQ(ends("left"), std::pair(Vec2(0, 2), Vec2(0, 0)));
    const auto& outlines = mesh.bodies[0].outlines;
    ASSERT_EQ(outlines.size(), 1U);
    EXPECT_EQ(outlines[0].nodes.size(), 12U);
    EXPECT_TRUE(outlines[0].closed);
}

TEST(BuildMesh, PutsNodesOfArcsOnTheirCircle) {
    const auto mesh = mesh_of(block("[[1, 0], [2, 0], [0, 2], [0, 1]]",
                                    "divisions = [3, 64]\n"
                                    "edges = { right = { arc = [1.4142135623730951, 1.4142135623730951] }, "
                                    "left = { arc = [0.7071067811865476, 0.7071067811865476] } }"));
    for (const auto node : edge(mesh, "right").nodes) EXPECT_NEAR(at(mesh, node).norm(), 2, 1e-14);
    for (const auto node : edge(mesh, "left").nodes) EXPECT_NEAR(at(mesh, node).norm(), 1, 1e-14);
    // Area of the inscribed polygons with 64 chords of a quarter circle.
    EXPECT_NEAR(area(mesh), 0.5 * (4 - 1) * 64 * std::sin(pi / 128), 1e-12);
}

TEST(PointsAlong, ArcsGoThroughTheirPointOnEitherSideAndTheLongWay) {
    for (const double y : {-2.0, -0.5, 0.5, 2.0}) {
        const double centre = (y * y - 1) / (2 * y);  // on x = 1, as far from (0, 0) as from (1, y)
        const auto points = points_along(Arc{{1, y}}, {0, 0}, {2, 0}, graded_fractions(10, 1));
        for (const auto& point : points)
            EXPECT_NEAR((point - Vec2(1, centre)).norm(), std::abs(y - centre), 1e-14);
        EXPECT_NEAR(points[5].y(), y, 1e-14);
    }
}

TEST(BuildMesh, SpreadsPolylinesByLength) {
    const auto mesh = mesh_of(block("[[0, 0], [4, 0], [4, 4], [0, 4]]",
                                    "divisions = [4, 2]\nedges = { top = { polyline = [[4, 5], [0, 5]] } }"));
    const auto& top = edge(mesh, "top").nodes;
    EXPECT_EQ(at(mesh, top[1]), Vec2(3.5, 5));
    EXPECT_EQ(at(mesh, top[2]), Vec2(2, 5));
    EXPECT_EQ(at(mesh, top[3]), Vec2(0.5, 5));
}

TEST(BuildMesh, GradesGeometrically) {
    const auto mesh =
        mesh_of(block("[[0, 0], [7, 0], [7, 1], [0, 1]]", "divisions = [3, 2]\ngrading = [4, 3]"));
    const auto& bottom = edge(mesh, "bottom").nodes;
    EXPECT_NEAR(at(mesh, bottom[1]).x(), 1, 1e-14);
    EXPECT_NEAR(at(mesh, bottom[2]).x(), 3, 1e-14);
    EXPECT_NEAR(at(mesh, edge(mesh, "left").nodes[1]).y(), 0.25, 1e-14);
    EXPECT_NEAR(at(mesh, edge(mesh, "right").nodes[1]).y(), 0.25, 1e-14);
}

TEST(BuildMesh, CutsCellsIntoTriangles) {
    const std::string shape = block("[[0, 0], [4, 0], [4, 2], [0, 2]]", "divisions = [4, 2]");
    const auto diagonal = mesh_of("element = \"triangle\"\n" + shape);
    EXPECT_EQ(diagonal.cell_count(), 16);
    EXPECT_DOUBLE_EQ(area(diagonal), 8);
    const auto crossed = mesh_of("element = \"triangle\"\npattern = \"crossed\"\n" + shape);
    EXPECT_EQ(crossed.cell_count(), 32);
    EXPECT_EQ(crossed.node_count(), 23);
    EXPECT_DOUBLE_EQ(area(crossed), 8);
}

/// A square ring of four blocks round a hole of side 2.
std::string ring(const std::string& last_corner = "[-1, 1]") {
    return block("[[-2, -2], [2, -2], [1, -1], [-1, -1]]",
                 "divisions = [4, 2]\nnames = { bottom = \"skin\" }") +
           block("[[2, -2], [2, 2], [1, 1], [1, -1]]", "divisions = [4, 2]\nnames = { bottom = \"skin\" }") +
           block("[[2, 2], [-2, 2], [-1, 1], [1, 1]]", "divisions = [4, 2]\nnames = { bottom = \"lid\" }") +
           block("[[-2, 2], [-2, -2], [-1, -1], " + last_corner + "]", "divisions = [4, 2]");
}

TEST(BuildMesh, JoinsBlocksIntoOneBodyWithAHole) {
    const auto mesh = mesh_of(ring());
    EXPECT_EQ(mesh.node_count(), 48);
    EXPECT_NEAR(area(mesh), 12, 1e-13);
    const auto& outlines = mesh.bodies[0].outlines;
    ASSERT_EQ(outlines.size(), 2U);
    EXPECT_EQ(outlines[0].name, "outline");
    EXPECT_EQ(outlines[0].nodes.size(), 16U);
    EXPECT_EQ(outlines[1].name, "outline 2");
    EXPECT_EQ(outlines[1].nodes.size(), 16U);
    for (const auto node : outlines[1].nodes) EXPECT_EQ(at(mesh, node).cwiseAbs().maxCoeff(), 1);
    // Two sides of one name make one chain, walked from the first to the last.
    const auto& skin = edge(mesh, "skin");
    EXPECT_EQ(skin.nodes.size(), 9U);
    EXPECT_FALSE(skin.closed);
    EXPECT_EQ(at(mesh, skin.nodes.front()), Vec2(-2, -2));
    EXPECT_EQ(at(mesh, skin.nodes.back()), Vec2(2, 2));
}

TEST(BuildMesh, MakesAClosedChainOfSidesThatCloseALoop) {
    const auto mesh = mesh_of(changed(ring(), "\"lid\"", "\"skin\"") + "names = { bottom = \"skin\" }\n");
    EXPECT_TRUE(edge(mesh, "skin").closed);
    EXPECT_EQ(edge(mesh, "skin").nodes.size(), 16U);
}

TEST(BuildMesh, RefusesBlocksThatDoNotFit) {
    const std::string left =
        block("[[0, 0], [1, 0], [1, 1], [0, 1]]", "divisions = [2, 2]\nnames = { left = \"l\" }");
    EXPECT_EQ(fault(left + block("[[1, 0], [2, 0], [2, 1], [1, 1]]", "divisions = [2, 4]")),
              "scene.toml:24:11: body 'b': a node at (1, 0.75) mm lies inside a cell side of another block; "
              "give touching "
              "sides the same corners, divisions and grading");
    EXPECT_EQ(fault(left + left),
              "scene.toml:16:1: body 'b': two blocks cover the same side at (0, 0); blocks may touch "
              "but not overlap");
    EXPECT_EQ(fault(left + block("[[1, 1], [2, 1], [2, 2], [1, 2]]", "divisions = [2, 2]")),
              "scene.toml:16:1: body 'b': blocks meet in a single node at (1, 1); let them share a whole "
              "side, or part "
              "them");
    EXPECT_EQ(fault(left + block("[[1, 0], [2, 0], [2, 1], [1, 1]]",
                                 "divisions = [2, 2]\nnames = { left = \"x\" }")),
              "scene.toml:16:1: body 'b': edge 'x' lies between two blocks at (1, 1); name sides of the "
              "boundary only");
    EXPECT_EQ(fault(left + block("[[1, 0], [2, 0], [2, 1], [1, 1]]",
                                 "divisions = [2, 2]\nnames = { right = \"l\" }")),
              "scene.toml:16:1: body 'b': the sides named 'l' do not connect at (0, 0); give the parts "
              "different names");
}

TEST(BuildMesh, OfRodsIsExact) {
    const auto mesh = build_mesh(load_scene(PERCUSS_SOURCE_DIR "/scenes/rods.toml"));
    ASSERT_EQ(mesh.bodies.size(), 2U);
    EXPECT_EQ(mesh.cell_count(), 750);
    EXPECT_NEAR(area(mesh), 3000, 1e-9);
    const auto& rod = mesh.bodies[1];
    EXPECT_EQ(rod.node_begin, mesh.bodies[0].node_end);
    for (const auto node : find_edge(rod, "face")->nodes) EXPECT_EQ(at(mesh, node).y(), 0);
    for (const auto node : find_edge(rod, "left")->nodes) EXPECT_EQ(at(mesh, node).x(), 0);
    EXPECT_EQ(select_nodes(mesh, rod, "left", std::array{0.0, 10.0, 1.0, 20.0}).size(), 6U);
    EXPECT_NEAR(smallest_side(mesh, rod), 2, 1e-12);
}

}  // namespace
}  // namespace percuss::testing
