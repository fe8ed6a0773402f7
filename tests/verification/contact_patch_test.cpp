// Uniform pressure through a contact face: what node-to-side contact can carry and what it cannot.
#include <algorithm>
#include <cmath>

#include "verification/run.hpp"

namespace percuss::testing {
namespace {

constexpr double pressure = 0.1, width = 12, height = 6;

/// Two blocks of the same width, the lower one on a fixed smooth bed; pressure on top grows over many periods
/// (of 5 us).
Scene blocks(int lower_columns, int upper_columns, const std::string& master, const std::string& slave) {
    return scene_of(scene_head("plane strain", 0.2, 0.3) +
                    box_body("lower", {0, 0, width, height}, {lower_columns, 6}, "",
                             "[[body.constraint]]\nedge = \"bottom\"\nfixed = [\"y\"]") +
                    box_body("upper", {0, height, width, 2 * height}, {upper_columns, 6}, "",
                             "[[body.load]]\nedge = \"top\"\npressure = [[0, 0], [0.2, 0.1]]") +
                    contact_pair("face", master, slave));
}

struct InterfaceError {
    double of_mean;     ///< mean interface stress against the pressure
    double of_pattern;  ///< worst deviation along the interface
};

/// Normal stress in the two element rows at the interface, both relative to the pressure.
InterfaceError interface_error(const Scene& scene, int lower_columns, int upper_columns) {
    RecordedRun run(scene);
    run.to_end();
    const auto snapshot = run.solver.snapshot();
    const auto& bodies = snapshot->setup->mesh.bodies;
    InterfaceError error{0, 0};
    const auto row_error = [&](std::int32_t first, int columns) {
        const auto begin = snapshot->stress.begin() + first, end = begin + columns;
        double mean = 0;
        std::for_each(begin, end, [&](const StressMean& s) { mean += s[1] / columns; });
        error.of_mean = std::max(error.of_mean, std::abs(mean / pressure + 1));
        std::for_each(begin, end, [&](const StressMean& s) {
            error.of_pattern = std::max(error.of_pattern, std::abs(s[1] - mean) / pressure);
        });
    };
    row_error(bodies[0].cell_end - lower_columns, lower_columns);
    row_error(bodies[1].cell_begin, upper_columns);
    return error;
}

TEST(ContactPatch, MatchingFacesPassUniformPressureExactly) {
    for (const auto& [master, slave] :
         {std::pair{"upper.bottom", "lower.top"}, std::pair{"lower.top", "upper.bottom"}}) {
        const InterfaceError error = interface_error(blocks(6, 6, master, slave), 6, 6);
        EXPECT_LT(error.of_mean, 0.01);  // the ramp's residual swing
        // Both blocks widen alike; nodes stay opposite each other to the lateral swing of the ramp.
        EXPECT_LT(error.of_pattern, 1e-2);
    }
}

TEST(ContactPatch, MatchingFacesAreUniformToRoundingBetweenSmoothWalls) {
    Scene scene = blocks(6, 6, "upper.bottom", "lower.top");
    for (Body& body : scene.bodies) {
        Constraint walls;
        walls.fixed = {true, false};
        body.constraints.push_back(walls);
    }
    // Rounding of positions, 2e-15 of 12 mm, times E / h over the pressure is 4e-12 a step; 1500 steps walk
    // 40 times as far.
    EXPECT_LT(interface_error(scene, 6, 6).of_pattern, 1e-9);
}

TEST(ContactPatch, NonMatchingFacesAreUniformOnlyWhereTheFinerSideIsMaster) {
    // One-pass node-to-side fails this patch by tens of percent, and how badly hangs on the choice of the
    // master: coarse master nodes leave fine slave nodes between them without support. Better schemes are
    // measured against this.
    for (const auto& [lower, upper] : {std::pair{5, 7}, std::pair{6, 9}, std::pair{5, 13}}) {
        const InterfaceError fine =
            interface_error(blocks(lower, upper, "upper.bottom", "lower.top"), lower, upper);
        const InterfaceError coarse =
            interface_error(blocks(lower, upper, "lower.top", "upper.bottom"), lower, upper);
        RecordProperty(
            fmt::format("{}_on_{}", lower, upper),
            fmt::format("fine master {:.3f}, coarse master {:.3f}", fine.of_pattern, coarse.of_pattern));
        EXPECT_LT(fine.of_pattern, 0.2) << lower << " on " << upper;
        EXPECT_GT(coarse.of_pattern, 0.2) << lower << " on " << upper;
        EXPECT_LT(fine.of_mean, 0.05) << lower << " on " << upper;
    }
}

TEST(ContactPatch, ResultantIsThePressureWhateverTheMesh) {
    RecordedRun run(blocks(5, 7, "upper.bottom", "lower.top"));
    run.to_end();
    const auto time = run.column("time"), force = run.column("contact.face.y");
    double mean = 0;
    std::size_t count = 0;
    for (std::size_t n = 0; n < time.size(); ++n) {
        if (time[n] < 0.1) continue;
        mean += force[n] / (pressure * width * time[n] / 0.2);
        ++count;
    }
    EXPECT_NEAR(mean / static_cast<double>(count), 1, 0.005);
}

}  // namespace
}  // namespace percuss::testing
