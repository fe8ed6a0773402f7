#include <algorithm>
#include <map>

#include <gtest/gtest.h>

#include "engine/scene/small_scene.hpp"
#include "engine/mesh/body_volume.hpp"
#include "mesh/select.hpp"

namespace percuss::testing {
namespace {

Scene nail_scene(const std::vector<std::string>& overrides = {}) {
    return load_scene(PERCUSS_SOURCE_DIR "/scenes/nail.toml", overrides);
}

std::string faults(const std::vector<std::string>& overrides) {
    try {
        const auto scene = nail_scene(overrides);
        check_mesh(scene, build_mesh(scene));
    } catch (const SceneError& error) {
        return error.what();
    }
    return "";
}

const MeshBody& body_of(const Mesh& mesh, const std::string& name) {
    return *std::find_if(mesh.bodies.begin(), mesh.bodies.end(),
                         [&](const MeshBody& body) { return body.name == name; });
}

Vec2 at(const Mesh& mesh, std::int32_t node) { return mesh.nodes[static_cast<std::size_t>(node)]; }

double mass(const Scene& scene, const Mesh& mesh, const MeshBody& body) {
    return scene.materials.at(0).density * testing::body_volume(mesh, body, scene.geometry, scene.thickness);
}

TEST(NailScene, HasTheCellsAndMassesOfTheCalibratedSetUp) {
    const auto scene = nail_scene();
    const auto mesh = build_mesh(scene);
    EXPECT_NO_THROW(check_mesh(scene, mesh));
    struct Expected {
        int cells;
        double grams, half_a_digit;
    };
    const std::map<std::string, Expected> table{
        {"substrate", {17 * 80, 308, 0.5}}, {"sheet2", {15 * 4, 9.86, 0.005}},
        {"sheet1", {15 * 4, 9.86, 0.005}},  {"washer", {10 * 4, 0.92, 0.005}},
        {"nail", {3 * 54, 2.84, 0.005}},    {"piston", {8 * 55, 37.5, 0.05}}};
    ASSERT_EQ(mesh.bodies.size(), table.size());
    double energy = 0;
    for (std::size_t b = 0; b < mesh.bodies.size(); ++b) {
        const auto& body = mesh.bodies[b];
        const auto& expected = table.at(body.name);
        EXPECT_EQ(body.cell_end - body.cell_begin, expected.cells) << body.name;
        EXPECT_NEAR(1e3 * mass(scene, mesh, body), expected.grams, expected.half_a_digit) << body.name;
        const auto& velocity = scene.bodies[b].velocity;
        energy += 0.5 * mass(scene, mesh, body) * (velocity[0] * velocity[0] + velocity[1] * velocity[1]);
    }
    EXPECT_NEAR(energy, 167.0, 0.1);
    EXPECT_EQ(mesh.cell_count(), 2122);
}

TEST(NailScene, HasItsProfileAndRoundedNose) {
    const auto mesh = build_mesh(nail_scene());
    const auto& nail = body_of(mesh, "nail");
    const auto& right = find_edge(nail, "right")->nodes;
    for (const auto node : right) {
        const double s = at(mesh, node).y() - 1.97, u = s / 8;
        const double radius =
            s < 8 ? 0.35 + 1.75 * (0.7 * (1 - (1 - u) * (1 - u)) + 0.3 * u) : 2.1 + 0.2 * (s - 8) / 20;
        EXPECT_NEAR(at(mesh, node).x(), radius, 1e-12);
    }
    for (std::size_t j = 1; j <= 20; ++j)
        EXPECT_NEAR(at(mesh, right[j]).y() - at(mesh, right[j - 1]).y(), 0.4, 1e-12);
    EXPECT_NEAR(at(mesh, right[54]).y() - at(mesh, right[53]).y(), 0.605, 0.01);
    // Row j is lowered by 0.24 (1 - (r/R)^2) exp(-j/1.5).
    auto axis = find_edge(nail, "left")->nodes;
    std::reverse(axis.begin(), axis.end());
    for (std::size_t j = 0; j <= 20; ++j) {
        const double row = static_cast<double>(j);
        EXPECT_NEAR(at(mesh, axis[j]).y(), 1.97 + 0.4 * row - 0.24 * std::exp(-row / 1.5), 1e-12);
    }
    const auto& bottom = find_edge(nail, "bottom")->nodes;
    EXPECT_NEAR(at(mesh, bottom[1]).y(), 1.97 - 0.24 * 8 / 9, 1e-12);
}

TEST(NailScene, GradesItsPlatesFromTheHole) {
    const auto mesh = build_mesh(nail_scene());
    for (const auto& [name, scale] :
         {std::pair("substrate", 24.6 / 25.458362), std::pair("sheet1", 19.6 / 20.458362)}) {
        const auto& bottom = find_edge(body_of(mesh, name), "bottom")->nodes;
        const auto width = [&](std::size_t i) {
            return at(mesh, bottom[i + 1]).x() - at(mesh, bottom[i]).x();
        };
        EXPECT_EQ(at(mesh, bottom[0]).x(), 0.4);
        EXPECT_NEAR(width(0), 0.45 * scale, 1e-6) << name;
        EXPECT_NEAR(width(1) / width(0), 1.15, 1e-9);
        EXPECT_NEAR(width(bottom.size() - 2), 2.5 * scale, 1e-6);
    }
}

TEST(NailScene, HasEightPairsAndAHeldBottom) {
    const auto scene = nail_scene();
    const auto mesh = build_mesh(scene);
    EXPECT_EQ(scene.contacts.size(), 8U);
    const auto& constraint = scene.bodies[0].constraints.at(0);
    EXPECT_EQ(constraint.fixed, (std::array{false, true}));
    const auto held = select_nodes(mesh, body_of(mesh, "substrate"), constraint.edge, constraint.box);
    EXPECT_GE(held.size(), 5U);
    for (const auto node : held) {
        EXPECT_EQ(at(mesh, node).y(), -20);
        EXPECT_GE(at(mesh, node).x(), 10);
    }
    // The chain of the substrate wraps the lip of the hole.
    const auto& surface = *find_edge(body_of(mesh, "substrate"), "surface");
    EXPECT_EQ(surface.nodes.size(), 17U + 80U + 1U);
    EXPECT_EQ(at(mesh, surface.nodes[17]), Vec2(0.4, 0));
}

TEST(NailScene, VariesWithItsParameters) {
    for (const auto* change :
         {"washer_bore=4.4", "washer_bore=4.7", "shank=3.99",       "shank=4.41", "cone=0.2",
          "tip=10",          "length=24",       "tip_radius=0.3",   "nose=0.2",   "washer_thickness=2",
          "washer_place=12", "upper_sheet=1.5", "lower_sheet=0.75", "gap=0",      "pilot_radius=0.5",
          "substrate=30",    "piston_mass=50",  "piston_speed=60",  "mesh=0.4",   "mesh=0.15"})
        EXPECT_EQ(faults({std::string("parameters.") + change}), "") << change;
    const auto scene = nail_scene({"parameters.piston_mass=50"});
    const auto mesh = build_mesh(scene);
    EXPECT_NEAR(1e3 * mass(scene, mesh, body_of(mesh, "piston")), 50, 1e-9);
    const auto fine = build_mesh(nail_scene({"parameters.mesh=0.125"}));
    EXPECT_NEAR(fine.cell_count(), 4 * 2122, 300);
}

TEST(NailScene, RefusesDesignsThatCannotBeBuilt) {
    const std::string file = PERCUSS_SOURCE_DIR "/scenes/nail.toml";
    EXPECT_EQ(faults({"parameters.washer_bore=4"}),
              "--set parameters.washer_bore=4: parameter 'washer_bore' is 4 mm; its range is 4.35 to 5 mm");
    // A nail that stands 2 mm deeper starts inside both sheets.
    const auto inside = faults({"parameters.nail_z== sheets_top - 1.5"});
    EXPECT_NE(inside.find("contact 'sheet1-nail': body 'sheet1' overlaps body 'nail' by "), std::string::npos)
        << inside;
    EXPECT_NE(inside.find("; move them apart until they touch or leave a gap"), std::string::npos);
    EXPECT_EQ(inside.find(file + ":"), 0U) << inside;
    EXPECT_NE(inside.find("contact 'sheet2-nail'"), std::string::npos);
}

}  // namespace
}  // namespace percuss::testing
