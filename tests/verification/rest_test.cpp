// A block that lies on another: which rows keep its swing, and which lose it (CONTACT.md).
#include <algorithm>
#include <cmath>

#include "verification/schemes.hpp"

namespace percuss::testing {
namespace {

RunStatistics at_rest(const std::string& scheme, const std::vector<std::string>& more = {}) {
    std::vector<std::string> overrides{"contact.rest.scheme=" + scheme, "model.duration=1"};
    overrides.insert(overrides.end(), more.begin(), more.end());
    RecordedRun run(load_scene(PERCUSS_SOURCE_DIR "/scenes/hard/rest.toml", overrides));
    run.to_end();
    double largest = 0;
    for (const double external : run.column("energy.external"))
        largest = std::max(largest, std::abs(external));
    EXPECT_LT(run.unexplained_energy(), 1e-9 * largest) << "all that is lost is work of contact";
    return run.solver.statistics();
}

TEST(Rest, IsKeptByRowsOfOneSurfaceAndByMeanGaps) {
    for (const char* scheme : {"node-to-side", "segment-to-segment"}) {
        const RunStatistics s = at_rest(scheme);
        EXPECT_EQ(s.pairs[0].openings, 0) << scheme;
        EXPECT_LT(s.maximum_loss, 1e-9) << scheme;
        EXPECT_LT(s.maximum_growth, 1e-3) << scheme;
    }
}

// Corners of both that do not match bear in turn, and stop where they close: what is lost is the work of
// contact. Where they match, none opens.
TEST(Rest, LosesBySymmetricRowsWhatNodesThatCloseAgainHad) {
    const RunStatistics s = at_rest("symmetric");
    EXPECT_GT(s.pairs[0].openings, 100);
    EXPECT_GT(s.maximum_loss, 1e-3);
    const RunStatistics matching =
        at_rest("symmetric", {"body.block.block.0.divisions=[8,4]", "body.base.block.0.divisions=[16,3]"});
    EXPECT_EQ(matching.pairs[0].openings, 0);
    EXPECT_LT(matching.maximum_loss, 1e-9);
}

}  // namespace
}  // namespace percuss::testing
