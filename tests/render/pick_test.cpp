#include "view/pick.hpp"

#include <gtest/gtest.h>

#include "render/synthetic.hpp"

namespace percuss::render {
namespace {

TEST(Pick, FindsBodyCellAndNearestNode) {
    const auto setup = synthetic::blocks(6, 4);  // lower: 60 x 40 in 6 x 4 cells; upper from y = 40
    const Snapshot now = synthetic::at_rest(setup);
    const Plane plane;
    const Picked lower = pick(now, plane, {-29, 1});
    EXPECT_EQ(lower.body, 0);
    EXPECT_EQ(lower.cell, 0);
    EXPECT_EQ(setup->mesh.nodes[static_cast<std::size_t>(lower.node)], Vec2(-30, 0));
    EXPECT_EQ(pick(now, plane, {1, 65}).body, 1);
    EXPECT_EQ(pick(now, plane, {25, 65}).body, -1);
    EXPECT_EQ(pick(now, plane, {25, 65}).cell, -1);
}

TEST(Pick, KnowsUprightAndMirroredPictures) {
    const auto setup = synthetic::rods(2, 4, 8);
    const Snapshot now = synthetic::at_rest(setup);
    const Vec2 centre = 0.25 * (setup->mesh.nodes[static_cast<std::size_t>(setup->mesh.cells[3][0])] +
                                setup->mesh.nodes[static_cast<std::size_t>(setup->mesh.cells[3][1])] +
                                setup->mesh.nodes[static_cast<std::size_t>(setup->mesh.cells[3][2])] +
                                setup->mesh.nodes[static_cast<std::size_t>(setup->mesh.cells[3][3])]);
    EXPECT_EQ(pick(now, {VerticalAxis::second, true}, {-centre[0], centre[1]}).cell, 3);
    EXPECT_EQ(pick(now, {VerticalAxis::first, true}, {centre[1], -centre[0]}).cell, 3);
    EXPECT_EQ(pick(now, {VerticalAxis::second, false}, {-centre[0], centre[1]}).cell, -1);
}

}  // namespace
}  // namespace percuss::render
