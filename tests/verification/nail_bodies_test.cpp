// The nail with its bodies paired without roles, against the paper's roles.
#include <cmath>
#include <fstream>
#include <regex>
#include <sstream>

#include "run/contact_forces.hpp"
#include "verification/schemes.hpp"

namespace percuss::testing {
namespace {

/// @param pair what stands for master ($1) and slave ($2) of each contact.
Scene nail(const std::string& pair) {
    std::ifstream file(PERCUSS_SOURCE_DIR "/scenes/nail.toml");
    std::stringstream text;
    text << file.rdbuf();
    const std::regex roles("master = \"([a-z0-9]+)\\.[a-z]+\"\nslave = \"([a-z0-9]+)\\.[a-z]+\"");
    return scene_of(std::regex_replace(text.str(), roles, pair), {"parameters.mesh=0.35"});
}

struct Peaks {
    double drive, axial, radial;  ///< magnitudes of moving averages [kN]
};

Peaks peaks_of(RecordedRun& run) {
    run.to_end();
    EXPECT_EQ(run.solver.statistics().contact_solver.fallbacks, 0);
    EXPECT_LT(run.solver.statistics().maximum_growth, 1e-5);
    const ContactAnalysis analysis = analyse_contacts(run.solver.setup()->scene, run.history);
    const auto pair = [&](const std::string& name) {
        return *std::find_if(analysis.pairs.begin(), analysis.pairs.end(),
                             [&](const ForceMeans& means) { return means.name == name; });
    };
    return {std::abs(pair("piston-nail").peak[1]), std::abs(pair("substrate-nail").peak[1]),
            std::abs(pair("substrate-nail").peak[0])};
}

void expect_close(const Peaks& a, const Peaks& b, double part) {
    EXPECT_NEAR(a.drive, b.drive, part * b.drive);
    EXPECT_NEAR(a.axial, b.axial, part * b.axial);
    EXPECT_NEAR(a.radial, b.radial, part * b.radial);
}

TEST(NailByBodies, AgreesWithThePapersRolesInWhateverOrderBodiesAreNamed) {
    RecordedRun roles(nail("$&")), bodies(nail("bodies = [\"$1\", \"$2\"]")),
        turned(nail("bodies = [\"$2\", \"$1\"]"));
    for (const ContactPair& pair : bodies.solver.setup()->scene.contacts) ASSERT_TRUE(pair.by_bodies);
    const Peaks papers = peaks_of(roles), ours = peaks_of(bodies), exchanged = peaks_of(turned);
    expect_close(ours, papers, 0.03);
    expect_close(exchanged, ours, 0.02);
}

}  // namespace
}  // namespace percuss::testing
