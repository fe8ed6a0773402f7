#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "engine/scene/small_scene.hpp"
#include "engine/mesh/body_volume.hpp"
#include "mesh/curve.hpp"
#include "mesh/select.hpp"

namespace percuss::testing {
namespace {

/// An axisymmetric scene of one body with one block of 2 x 4; `rest` are further lines of the block.
std::string turned(const std::string& rest, const std::string& body = "",
                   const std::string& corners = "[[0, 0], [1, 0], [2, 4], [0, 4]]",
                   const std::string& parameters = "top_radius = 2") {
    const std::string head = changed(small_scene.substr(0, small_scene.find("[[body]]")), "percuss = 1\n",
                                     "percuss = 1\n[parameters]\n" + parameters + "\n");
    return head + "[[body]]\nname = \"b\"\nmaterial = \"steel\"\n" + body +
           "\n[[body.block]]\ncorners = " + corners + "\n" + rest + "\n";
}

Mesh mesh_of(const std::string& text) { return build_mesh(parse_scene(text, "scene.toml")); }

const Vec2& at(const Mesh& mesh, std::int32_t node) { return mesh.nodes[static_cast<std::size_t>(node)]; }

const Edge& edge(const Mesh& mesh, const std::string& name) { return *find_edge(mesh.bodies.at(0), name); }

const std::string cells = "divisions = [2, 4]\n";

TEST(FormulaSide, OfOneCoordinateRunsEvenlyAlongTheOther) {
    const auto mesh =
        mesh_of(turned(cells + "edges = { right = { r = \"= 1 + (top_radius - 1)*(z/4)^2\" } }"));
    const auto& right = edge(mesh, "right").nodes;
    for (std::size_t j = 0; j <= 4; ++j) {
        const double z = static_cast<double>(j);
        EXPECT_NEAR(at(mesh, right[j]).y(), z, 1e-14);
        EXPECT_NEAR(at(mesh, right[j]).x(), 1 + z * z / 16, 1e-14);
    }
    // The other way round: the top as z(r).
    const auto lid = mesh_of(turned(cells + "edges = { top = { z = \"= 4 + r*(2 - r)\" } }"));
    EXPECT_NEAR((at(lid, edge(lid, "top").nodes[1]) - Vec2(1, 5)).norm(), 0, 1e-14);
}

TEST(FormulaSide, OfBothCoordinatesRunsFromZeroToOne) {
    const auto mesh =
        mesh_of(turned("divisions = [2, 64]\nedges = { right = { r = \"= cos(s*pi/2)\", "
                       "z = \"= sin(s*pi/2)\" }, left = \"straight\" }",
                       "", "[[0.5, 0], [1, 0], [0, 1], [0, 0.5]]"));
    for (const auto node : edge(mesh, "right").nodes) EXPECT_NEAR(at(mesh, node).norm(), 1, 1e-14);
}

TEST(FormulaSide, MakesTheVolumeOfAParaboloid) {
    const auto text = turned("divisions = [1, 400]\nedges = { right = { r = \"= sqrt(1 + z)\" } }", "",
                             "[[0, 0], [1, 0], [2, 3], [0, 3]]");
    const auto mesh = mesh_of(text);
    // pi times the integral of (1 + z) from 0 to 3.
    EXPECT_NEAR(testing::body_volume(mesh, mesh.bodies[0], Geometry::axisymmetric, 1), 7.5 * std::numbers::pi, 1e-4);
}

TEST(SideLength, IsExactForLinesAndArcs) {
    EXPECT_EQ(side_length(Straight{}, {0, 0}, {3, 4}), 5);
    EXPECT_EQ(side_length(Polyline{{{0, 4}}}, {0, 0}, {3, 4}), 7);
    EXPECT_NEAR(side_length(Arc{{std::sqrt(0.5), std::sqrt(0.5)}}, {1, 0}, {0, 1}), std::numbers::pi / 2,
                1e-6);
}

TEST(Shift, MovesNodesByFormulasOfTheirOldPlaces) {
    const auto plain = mesh_of(turned(cells));
    const auto mesh = mesh_of(
        turned(cells + "shift = { r = \"= 0.01*r*i*(Z - z)\", z = \"= -0.24*(1 - (r/R)^2)*exp(-j)\" }"));
    for (int j = 0; j <= 4; ++j) {
        const double end = plain.nodes[static_cast<std::size_t>(3 * j + 2)].x();
        for (int i = 0; i <= 2; ++i) {
            const auto node = static_cast<std::size_t>(3 * j + i);
            const double r = plain.nodes[node].x(), z = plain.nodes[node].y();
            EXPECT_NEAR(mesh.nodes[node].x(), r + 0.01 * r * i * (4 - z), 1e-14);
            EXPECT_NEAR(mesh.nodes[node].y(), z - 0.24 * (1 - r * r / (end * end)) * std::exp(-j), 1e-14);
        }
    }
}

TEST(Divisions, BySizesAreMeasuredAlongBottomAndLeft) {
    const auto mesh =
        mesh_of(turned("divisions = [{ sizes = [1, 3] }, [{ length = 1, first = 0.5 }, { first = 1, ratio = "
                       "2, largest = 2 }]]"));
    EXPECT_NEAR(at(mesh, edge(mesh, "bottom").nodes[1]).x(), 0.25, 1e-15);
    EXPECT_NEAR(at(mesh, edge(mesh, "top").nodes[1]).x(), 0.5, 1e-15);
    std::vector<double> heights;
    for (const auto node : edge(mesh, "right").nodes) heights.push_back(at(mesh, node).y());
    ASSERT_EQ(heights.size(), 5U);
    EXPECT_NEAR(heights[1], 0.5, 1e-14);
    EXPECT_NEAR(heights[2], 1, 1e-14);
    EXPECT_NEAR(heights[3], 2, 1e-14);
}

TEST(Chain, JoinsSidesRoundTheCorner) {
    const auto mesh =
        mesh_of(turned(cells, "chains = { skin = [\"right\", \"bottom\"], lip = [\"top\", \"right\"] }"));
    const auto& skin = edge(mesh, "skin");
    EXPECT_FALSE(skin.closed);
    ASSERT_EQ(skin.nodes.size(), 7U);
    EXPECT_EQ(at(mesh, skin.nodes.front()), Vec2(0, 0));
    EXPECT_EQ(at(mesh, skin.nodes[2]), Vec2(1, 0));
    EXPECT_EQ(at(mesh, skin.nodes.back()), Vec2(2, 4));
    EXPECT_EQ(edge(mesh, "right").nodes.size(), 5U);
    EXPECT_EQ(edge(mesh, "lip").nodes.size(), 7U);
}

TEST(Names, GivenToAdjacentSidesOfABlockJoinThem) {
    const auto mesh = mesh_of(turned(cells + "names = { bottom = \"skin\", right = \"skin\" }"));
    EXPECT_EQ(edge(mesh, "skin").nodes.size(), 7U);
}

struct Broken {
    std::string rest, message;
};

class BrokenTurned : public ::testing::TestWithParam<Broken> {};

TEST_P(BrokenTurned, SaysWhereAndWhy) {
    const auto& [rest, message] = GetParam();
    EXPECT_EQ(faults_of(turned(rest)), "scene.toml:" + message);
}

INSTANTIATE_TEST_SUITE_P(
    Mesh, BrokenTurned,
    ::testing::Values(
        Broken{cells + "edges = { right = { r = \"= 1 + z/8\" } }",
               "25:25: body 'b': the formula \"= 1 + z/8\" ends at r = 1.5, but the corner there has r = 2"},
        Broken{cells + "edges = { right = { r = \"= 1 + z*z/(z - 2)\" } }",
               "25:25: body 'b': the formula \"= 1 + z*z/(z - 2)\" has no value at z = 2: division by zero"},
        Broken{cells + "edges = { right = { r = \"= 1 + zz/8\" } }",
               "25:25: 'r' = \"= 1 + zz/8\": unknown name 'zz'; valid: z, top_radius"},
        Broken{cells + "edges = { right = { r = \"= 1 + r/8\" } }",
               "25:25: 'r' = \"= 1 + r/8\": unknown name 'r'; valid: z, top_radius"},
        Broken{cells + "edges = { right = { x = \"= 1 + y/8\" } }",
               "25:19: 'right' must have one of arc, polyline and formulas of r and z; write e.g. right = "
               "{arc = "
               "[1, 2]}\nscene.toml:25:21: unknown key 'x' in [body.block.edges.right]; valid: arc, "
               "polyline, r, z"},
        Broken{cells + "edges = { right = { r = \"= 1 + z/4\", arc = [1, 2] } }",
               "25:19: 'right' must have one of arc, polyline and formulas of r and z; write e.g. right = "
               "{arc = "
               "[1, 2]}"},
        Broken{cells + "edges = { right = { r = \"= 1 + z/4 +\" } }",
               "25:25: 'r' = \"= 1 + z/4 +\": it ends too early"},
        Broken{cells + "shift = { z = \"= 1/r\" }",
               "25:15: body 'b': the formula \"= 1/r\" has no value at r = 0: division by zero"},
        Broken{cells + "shift = { z = \"= 0*s\" }",
               "25:15: 'z' = \"= 0*s\": unknown name 's'; valid: r, z, i, j, R, Z, top_radius"},
        Broken{cells + "shift = {}", "25:9: 'shift' moves nothing; write z = \"= FORMULA\""},
        Broken{
            "divisions = [2, { first = 1, sizes = [1] }]",
            "24:17: 'divisions[1]' must have one of first, last and sizes; write e.g. {first = 0.5, ratio = "
            "1.1, largest = 2}"},
        Broken{"divisions = [2, [4]]", "24:18: 'divisions[1][0]' is an integer; it must be a table"},
        Broken{"divisions = [2, { first = 2, largest = 1 }]",
               "24:40: 'largest' is 1, below the first size 2"},
        Broken{"divisions = [2, { first = 1, ratio = 0.5 }]",
               "24:38: 'ratio' is 0.5; it must be >= 1 and <= 10"},
        Broken{"divisions = [2, { length = 3, first = 1 }]",
               "24:17: 'divisions[1]' has stretches that do not add up to the side, of length 4: 3 ends "
               "after 0"},
        Broken{"divisions = [2, { first = 1 }]\ngrading = [1, 2]",
               "25:11: 'grading[1]' is 2 where 'divisions[1]' gives the sizes; keep one"},
        Broken{"divisions = [2, { first = 1e-7 }]",
               "24:17: 'divisions[1]' makes more than 1000000 cells; enlarge them"},
        Broken{"divisions = 4",
               "24:13: 'divisions' is an integer; it must be an array of 2, each a number of cells or their "
               "sizes"}));

TEST(BrokenTurned, ChainsNameEdgesOfTheBody) {
    EXPECT_EQ(faults_of(turned(cells, "chains = { skin = [\"rihgt\"] }")),
              "scene.toml:21:19: body 'b' has no edge 'rihgt'; did you mean 'right'?");
    EXPECT_EQ(faults_of(turned(cells, "chains = { top = [\"right\"] }")),
              "scene.toml:21:18: body 'b' has an edge 'top' already; give the chain a name of its own");
    EXPECT_EQ(faults_of(turned(cells, "chains = { skin = [\"bottom\", \"top\"] }")),
              "scene.toml:18:1: body 'b': the sides named 'skin' do not connect at (1, 0); give the parts "
              "different names");
    EXPECT_EQ(faults_of(turned(cells, "chains = { skin = [] }")),
              "scene.toml:21:19: 'skin' is empty; write skin = [\"left\", \"top\"]");
}

}  // namespace
}  // namespace percuss::testing
