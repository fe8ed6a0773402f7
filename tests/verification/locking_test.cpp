// Collapse loads of perfectly plastic bodies against their closed forms: elements that lock do not keep to
// them.
#include <cmath>
#include <numbers>

#include "verification/run.hpp"

namespace percuss::testing {
namespace {

constexpr double yield = 0.4;
const double shear_yield = yield / std::sqrt(3.0);

Scene plastic_scene(const std::string& geometry, double duration, const std::string& body) {
    return scene_of(scene_head(geometry, duration, 0.495, "courant = 0.9",
                               fmt::format("[material.plastic]\nyield = {}\n", yield)) +
                    body);
}

std::string held(const std::string& edge, const std::string& directions) {
    return fmt::format("[[body.constraint]]\nedge = \"{}\"\nfixed = [{}]\n", edge, directions);
}

/// A load over its limit: mean of the last quarter of a run, and of the quarter before it.
struct Plateau {
    double before, last;
};

template <class OfRow>
Plateau plateau(std::size_t rows, OfRow of_row) {
    const auto mean = [&](std::size_t begin, std::size_t end) {
        double sum = 0;
        for (std::size_t k = begin; k < end; ++k) sum += of_row(k);
        return sum / static_cast<double>(end - begin);
    };
    return {mean(rows / 2, 3 * rows / 4), mean(3 * rows / 4, rows)};
}

/// Prandtl's punch in plane strain: rough, rigid, of half width b, it sinks 0.05 b into a half space. Limit:
/// mean pressure (2 + pi) k.
Plateau punch(const std::string& element, int cells) {
    constexpr double half = 4, depth = 16, width = 24;
    const auto block = [&](double left, double right, int columns, const std::string& names) {
        return fmt::format(
            "[[body.block]]\ncorners = [[{0}, {2}], [{1}, {2}], [{1}, 0], [{0}, 0]]\n"
            "divisions = [{3}, {4}]\nnames = {{ {5} }}\n",
            left, right, -depth, columns, static_cast<int>(std::lround(depth / half * cells)), names);
    };
    RecordedRun run(plastic_scene(
        "plane strain", 0.1,
        fmt::format("[[body]]\nname = \"ground\"\nmaterial = \"steel\"\nelement = \"{}\"\n", element) +
            block(0, half, cells, "top = \"punch\", left = \"axis\", bottom = \"bed\"") +
            block(half, width, 5 * cells, "right = \"side\", bottom = \"bed\"") + held("axis", "\"x\"") +
            held("side", "\"x\", \"y\"") + held("bed", "\"x\", \"y\"") + held("punch", "\"x\"") +
            "[[body.prescribed]]\nedge = \"punch\"\ndirection = \"y\"\nvelocity = [[0, 0], [0.02, "
            "-2.22]]\n"));
    run.to_end();
    const auto force = run.column("body.ground.drive.y");
    const double limit = (2 + std::numbers::pi) * shear_yield * half;
    return plateau(force.size(), [&](std::size_t k) { return -force[k] / limit; });
}

/// A ring between smooth plates, its bore widened by a tenth. Limit: bore pressure 2 k ln(b/a) of the present
/// radii.
Plateau ring(const std::string& element, int cells) {
    constexpr double inner = 5, outer = 10, height = 2, speed = 1, start = 0.05, duration = 0.525;
    RecordedRun run(plastic_scene(
        "axisymmetric", duration,
        box_body("ring", {inner, 0, outer, height}, {cells, 2 * cells / 5},
                 fmt::format("element = \"{}\"", element),
                 held("bottom", "\"axial\"") + held("top", "\"axial\"") +
                     fmt::format("[[body.prescribed]]\nedge = \"left\"\ndirection = \"radial\"\n"
                                 "velocity = [[0, 0], [{}, {}]]\n",
                                 start, speed))));
    run.to_end();
    const auto force = run.column("body.ring.drive.radial"), time = run.column("time");
    return plateau(force.size(), [&](std::size_t k) {
        const double a = inner + speed * (time[k] - start / 2);
        const double b = std::sqrt(a * a + outer * outer - inner * inner);
        return force[k] / (2 * std::numbers::pi * a * height) / (2 * shear_yield * std::log(b / a));
    });
}
TEST(CollapseLoad, OfAPunchIsReachedByAveragedTriangles) {
    // A coarse mesh yields with the cell beside the punch's edge, half of which acts: 1 + h/(2b) of the
    // limit. Sinking by 0.04 b on average adds about as much of the surrounding height: an estimate, which
    // the runs do not contradict, hence the tolerance.
    for (const auto& [element, cells] :
         {std::pair{"averaged triangle", 4}, {"averaged triangle", 8}, {"mean-dilatation quad", 4}}) {
        const Plateau load = punch(element, cells);
        RecordProperty(fmt::format("{} {}", element, cells), fmt::format("{} {}", load.before, load.last));
        EXPECT_NEAR(load.last, 1 + 0.5 / cells + 0.04, 0.05) << element << cells;
        EXPECT_LT(load.last, 1.015 * load.before) << element << cells;
    }
    // Triangles alone have no limit load: the force grows on.
    const Plateau alone = punch("triangle", 4);
    RecordProperty("triangle 4", fmt::format("{} {}", alone.before, alone.last));
    EXPECT_GT(alone.last, 2);
    EXPECT_GT(alone.last, 1.08 * alone.before);
}

TEST(CollapseLoad, OfAThickRingIsReachedByAveragedTriangles) {
    // Ten cells over the wall: (h/r)^2 / 12 of each stress at the bore, and elastic strains of yield / young:
    // 1e-3 each.
    for (const std::string element : {"one-point quad", "mean-dilatation quad", "averaged triangle"}) {
        const Plateau load = ring(element, 10);
        RecordProperty(element, fmt::format("{} {}", load.before, load.last));
        EXPECT_NEAR(load.last, 1, 2e-3) << element;
        EXPECT_NEAR(load.before, 1, 2e-3) << element;
    }
    const Plateau alone = ring("triangle", 10);
    RecordProperty("triangle", fmt::format("{} {}", alone.before, alone.last));
    EXPECT_GT(alone.last, 1.01);
}

}  // namespace
}  // namespace percuss::testing
