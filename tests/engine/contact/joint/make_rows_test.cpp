#include "contact/joint/make_rows.hpp"

#include <gtest/gtest.h>

#include "mesh/build.hpp"
#include "verification/schemes.hpp"

namespace percuss::testing {
namespace {

// Whichever body's nodes are kept out, and whatever the order in which the pair names the two.
TEST(MakeRows, KeysAndOwnersAreBelowTheirNumbers) {
    for (const char* scheme : {"node-to-side", "symmetric", "segment-to-segment"})
        for (const bool swapped : {false, true}) {
            const Scene scene =
                scene_of(scene_head("plane strain", 1, 0.3) + box_body("coarse", {0, 2, 4, 4}, {3, 2}) +
                         box_body("fine", {0, 0, 4, 2}, {9, 4}) + joint_problem +
                         bodies_pair("hit", swapped ? "fine" : "coarse", swapped ? "coarse" : "fine",
                                     std::string(scheme)));
            const Mesh mesh = build_mesh(scene);
            AlignedVector<Node> nodes;
            for (const Vec2& x : mesh.nodes) nodes.push_back({{x.x(), x.y()}, {0, 0}});
            const PairSurfaces surfaces = pair_surfaces(scene, mesh, scene.contacts[0]);
            AnyRowBuilder builder = make_rows(scene, mesh, scene.contacts[0]);
            ContactRows rows;
            builder->find({nodes.data(), 1e-3, 1e-3, 1}, rows);
            EXPECT_GE(rows.size(), 9U) << scheme;
            for (const ContactRow& row : rows) {
                EXPECT_LT(static_cast<std::size_t>(row.key), builder->size().keys) << scheme << swapped;
                EXPECT_LT(static_cast<std::size_t>(row.owner),
                          surfaces.master.nodes.size() + surfaces.slave.nodes.size());
            }
        }
}

}  // namespace
}  // namespace percuss::testing
