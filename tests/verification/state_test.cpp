// A saved state goes on as the run that was never interrupted, bit by bit, whatever the scene asks for.
#include <algorithm>
#include <functional>
#include <ostream>

#include "verification/run.hpp"

namespace percuss::testing {
namespace {

/// Two blocks, one driven into the other for a while, then let go.
Scene driven_for_a_while() {
    return scene_of(
        scene_head("plane strain", 0.04, 0.3) +
        box_body("ram", {0, 4, 6, 8}, {6, 4}, "",
                 "[[body.prescribed]]\nedge = \"top\"\ndirection = \"y\"\nvelocity = [[0, 0], [0.004, -20]]\n"
                 "from = 0.002\nuntil = 0.008\n") +
        box_body("block", {1, 0, 7, 4}, {5, 4}) + contact_pair("push", "ram.bottom", "block.top"));
}

/// A corner that slides over a corner: which face holds a node depends on where it came from.
Scene past_a_corner(const std::string& scheme) {
    return scene_of(scene_head("plane strain", 0.1, 0.3) + "[contact_solver]\nscheme = \"" + scheme + "\"\n" +
                    box_body("flyer", {-6, 0.01, 0.5, 4}, {13, 8}, "velocity = [30, -20]") +
                    box_body("block", {0, -6, 8, 0}, {8, 6}, "velocity = [-5, 0]") +
                    "[[contact]]\nname = \"hit\"\nmaster = \"flyer\"\nslave = \"block\"\n");
}

Scene nail(const std::string& scheme) {
    return load_scene(PERCUSS_SOURCE_DIR "/scenes/nail.toml",
                      {"parameters.mesh=0.5", "contact_solver.scheme=" + scheme});
}

struct Kind {
    const char* name;
    std::function<Scene()> scene;
    std::int64_t steps = 600;  ///< at most
};

void PrintTo(const Kind& kind, std::ostream* to) { *to << kind.name; }

const Kind kinds[] = {{"rods", [] { return rods(); }},
                      {"rods_lagged",
                       [] {
                           return rods({"model.lagged=true", "model.energy_growth_limit=100"});
                       }},
                      {"rods_averaged", [] { return rods({"body.striker.element=mean-dilatation quad"}); }},
                      {"corner_by_pairs", [] { return past_a_corner("projection"); }},
                      {"corner_jointly", [] { return past_a_corner("joint"); }},
                      {"nail_jointly", [] { return nail("joint"); }, 1500},
                      {"nail_by_pairs", [] { return nail("projection"); }, 1500},
                      {"taylor", [] { return load_scene(PERCUSS_SOURCE_DIR "/scenes/taylor.toml"); }},
                      {"driven", [] { return driven_for_a_while(); }}};

class SavedState : public ::testing::TestWithParam<Kind> {};

TEST_P(SavedState, GoesOnBitByBit) {
    Solver whole(GetParam().scene()), parts(GetParam().scene());
    std::vector<SolverState> saved;
    std::vector<std::vector<double>> rows;
    while (!whole.finished() && whole.steps() < GetParam().steps) {
        if (whole.steps() % 37 == 0) saved.push_back(whole.save());
        const auto divergence = whole.step();
        ASSERT_FALSE(divergence) << divergence->message;
        rows.emplace_back(whole.history_row().begin(), whole.history_row().end());
    }
    ASSERT_GT(saved.size(), 4U);
    const RunStatistics expected = whole.statistics();
    // Later states first: nothing of them may be left behind.
    for (std::size_t k = saved.size(); k-- > 0;) {
        // From most of them only up to the next.
        const bool to_end = k == saved.size() / 2 || k == 0;
        const std::int64_t last = to_end ? whole.steps() : std::min(saved[k].step + 40, whole.steps());
        parts.restore(saved[k]);
        while (parts.steps() < last) {
            const auto step = static_cast<std::size_t>(parts.steps());
            ASSERT_FALSE(parts.step());
            const std::vector<double> row(parts.history_row().begin(), parts.history_row().end());
            ASSERT_EQ(row, rows[step]) << "step " << step << " from state " << saved[k].step;
        }
        if (!to_end) continue;
        EXPECT_EQ(parts.statistics().state_hash, expected.state_hash) << "from step " << saved[k].step;
        for (std::size_t p = 0; p < expected.pairs.size(); ++p) {
            EXPECT_EQ(parts.statistics().pairs[p].openings, expected.pairs[p].openings);
            EXPECT_EQ(parts.statistics().pairs[p].impulse, expected.pairs[p].impulse);
        }
    }
}

TEST_P(SavedState, ShowsWhatItShowedBefore) {
    Solver solver(GetParam().scene());
    const auto touches = [&] {
        const auto pairs = solver.snapshot()->pairs;
        return std::any_of(pairs.begin(), pairs.end(), [](const PairState& pair) { return pair.active > 0; });
    };
    while (solver.steps() < 30 || !touches()) ASSERT_FALSE(solver.step());
    const SolverState state = solver.save();
    const auto seen = solver.snapshot();
    for (int n = 0; n < 20; ++n) ASSERT_FALSE(solver.step());
    solver.restore(state);
    const auto again = solver.snapshot();
    EXPECT_EQ(again->position, seen->position);
    EXPECT_EQ(again->velocity, seen->velocity);
    EXPECT_EQ(again->stress, seen->stress);
    EXPECT_EQ(again->plastic_strain, seen->plastic_strain);
    ASSERT_EQ(again->contact_forces.size(), seen->contact_forces.size());
    for (std::size_t k = 0; k < seen->contact_forces.size(); ++k) {
        EXPECT_EQ(again->contact_forces[k].node, seen->contact_forces[k].node);
        EXPECT_EQ(again->contact_forces[k].force, seen->contact_forces[k].force);
    }
    for (std::size_t p = 0; p < seen->pairs.size(); ++p) {
        EXPECT_EQ(again->pairs[p].force, seen->pairs[p].force);
        EXPECT_EQ(again->pairs[p].active, seen->pairs[p].active);
        EXPECT_EQ(again->pairs[p].penetration, seen->pairs[p].penetration);
    }
    EXPECT_EQ(again->energy.balance(), seen->energy.balance());
}

INSTANTIATE_TEST_SUITE_P(Scenes, SavedState, ::testing::ValuesIn(kinds),
                         [](const auto& kind) { return std::string(kind.param.name); });

}  // namespace
}  // namespace percuss::testing
