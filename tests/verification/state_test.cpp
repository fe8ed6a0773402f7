// A saved state goes on as the run that was never interrupted, bit by bit, whatever the scene asks for.
#include <algorithm>

#include "verification/kinds.hpp"

namespace percuss::testing {
namespace {

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
            EXPECT_EQ(parts.statistics().pairs[p].friction_work, expected.pairs[p].friction_work);
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

INSTANTIATE_TEST_SUITE_P(Scenes, SavedState, ::testing::ValuesIn(kinds_of_runs),
                         [](const auto& kind) { return std::string(kind.param.name); });

}  // namespace
}  // namespace percuss::testing
