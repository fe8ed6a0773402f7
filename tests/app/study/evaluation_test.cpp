#include "study/evaluation.hpp"

#include <cmath>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/scene/small_scene.hpp"
#include "exit_status.hpp"
#include "record/sample_run.hpp"
#include "study/study_table.hpp"

namespace percuss::app {
namespace {

using percuss::testing::changed;
using percuss::testing::small_scene;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// A study whose results are made up: nothing is run.
class EvaluationTest : public ::testing::Test {
  protected:
    [[nodiscard]] Study study(const std::vector<std::string>& vary,
                              const std::vector<std::string>& quantities,
                              const std::string& more = "") const {
        const auto file = folder_.path() / "scene.toml";
        std::ofstream(file) << changed(small_scene, "divisions = [4, 8]",
                                       "divisions = [4, \"= round(8/mesh)\"]")
                            << "[parameters]\nmesh = 1\nmass = 1\n"
                            << more;
        StudyRequest request;
        request.file = file.string();
        request.vary = vary;
        request.quantities = quantities;
        return make_study(request);
    }

    /// Finished cases of so many elements and steps with one number each.
    template <class Value>
    static std::vector<CaseResult> results(const Study& study, Value value) {
        std::vector<CaseResult> all;
        for (const StudyCase& each : study.cases) {
            CaseResult result;
            result.state = CaseState::finished;
            const double h = of(study, each, "parameters.mesh", 1),
                         dt = of(study, each, "model.step.courant", 0.5);
            result.summary = {
                {"elements", 400 / (h * h)}, {"steps", 100 / (h * dt)}, {"peak", value(each, h, dt)}};
            result.seconds = {1 / (h * h * h * dt)};
            all.push_back(result);
        }
        return all;
    }
    static double of(const Study& study, const StudyCase& one, const std::string& key, double otherwise) {
        for (std::size_t a = 0; a < study.axes.size(); ++a)
            if (study.axes[a].axis.key == key) return std::stod(study.axes[a].values[one.at[a]].label);
        return otherwise;
    }

    percuss::test::TemporaryFolder folder_;
};

TEST_F(EvaluationTest, WithoutAnExactAnswerErrorsAreAgainstTheExtrapolatedOne) {
    const Study s = study({"parameters.mesh=4,1,2", "model.step.courant=0.9,0.3"}, {"peak"});
    const auto all =
        results(s, [](const StudyCase&, double h, double) { return 10 + 0.2 * std::pow(h, 1.5); });
    const Evaluation e = evaluate(s, all);
    ASSERT_EQ(e.designs.size(), 1U);
    EXPECT_NEAR(*e.designs[0].references[0].value, 10, 1e-9);
    EXPECT_NEAR(e.designs[0].references[0].uncertainty, 1.25 * 0.02, 1e-9);
    EXPECT_NEAR(*e.errors[0][0], 0.02 * 8, 1e-9);  // h = 4
    EXPECT_NEAR(*e.errors[2][0], 0.02, 1e-9);      // h = 1
    // Orders: of the mesh at both steps; the values know nothing of the step.
    ASSERT_EQ(e.orders.size(), 2U);
    for (const ObservedOrder& order : e.orders) EXPECT_NEAR(order.order, 1.5, 1e-9);
    // The large step is cheaper at the same error: the front is of its cases alone.
    EXPECT_THAT(e.designs[0].fronts[0], ElementsAre(0, 4, 2));
}

TEST_F(EvaluationTest, AnExactAnswerGivesErrorsAndTheCheapestWithinTheTolerance) {
    Study s = study({"parameters.mesh=1,2,4"}, {"peak=8"});
    s.quantities[0].tolerance = 0.3;
    const auto all = results(s, [](const StudyCase&, double h, double) { return 8 + h; });
    const Evaluation e = evaluate(s, all);
    EXPECT_NEAR(*e.errors[0][0], 0.125, 1e-12);
    EXPECT_EQ(e.designs[0].cheapest[0], 1U);
    EXPECT_NEAR(e.orders.at(0).order, 1, 1e-9);
    EXPECT_TRUE(e.designs[0].references[0].exact);
    const auto rows = cheapest_rows(s, all, e);
    EXPECT_EQ(rows[1][5], "mesh 2");
}

TEST_F(EvaluationTest, EveryDesignHasAReferenceOfItsOwn) {
    const Study s = study({"parameters.mass=1,2", "parameters.mesh=1,2,4"}, {"peak"});
    const auto all = results(s, [&](const StudyCase& each, double h, double) {
        return 100 * of(s, each, "parameters.mass", 0) + h;
    });
    const Evaluation e = evaluate(s, all);
    ASSERT_EQ(e.designs.size(), 2U);
    EXPECT_EQ(e.designs[1].label, "mass 2");
    EXPECT_NEAR(*e.designs[0].references[0].value, 100, 1e-9);
    EXPECT_NEAR(*e.designs[1].references[0].value, 200, 1e-9);
    EXPECT_NEAR(*e.errors[3][0], 1 / 200.0, 1e-12);
}

TEST_F(EvaluationTest, CasesThatDidNotFinishAreNoReferenceAndOnNoFront) {
    const Study s = study({"scheme=projection,lagged", "parameters.mesh=1,2,4"}, {"peak"});
    auto all = results(s, [](const StudyCase&, double h, double) { return 10 + h; });
    for (const std::size_t i : {0U, 3U, 4U, 5U}) {
        all[i].state = i == 0 ? CaseState::failed : CaseState::diverged;
        all[i].message = "boom";
    }
    const Evaluation e = evaluate(s, all);
    EXPECT_NEAR(*e.designs[0].references[0].value, 12, 1e-12) << "two levels are left: the finest of them";
    EXPECT_EQ(e.designs[0].references[0].own, 1U);
    EXPECT_FALSE(e.errors[0][0]);
    EXPECT_FALSE(e.errors[1][0]) << "nothing is judged by itself";
    EXPECT_NEAR(*e.errors[2][0], 2 / 12.0, 1e-12);
    EXPECT_THAT(e.designs[0].fronts[0], ElementsAre(2));
    const auto rows = study_rows(s, all, e);
    EXPECT_EQ(rows[1][2], "failed");
    EXPECT_EQ(rows[2][2], "reference");
    EXPECT_EQ(rows[4][2], "diverged");
    EXPECT_THAT(study_csv(s, all, e), HasSubstr("lagged,1,diverged,,,"));
}

TEST_F(EvaluationTest, TheReferenceIsTakenFromTheScenesOwnMethodAndTheSmallestStep) {
    const Study s =
        study({"scheme=joint,projection", "model.step.courant=0.2,0.8", "parameters.mesh=1,2,4"}, {"peak"});
    const auto all = results(s, [&](const StudyCase& each, double h, double dt) {
        return (each.at[0] == 1 ? 10 : 20) + h + (dt > 0.5 ? 5 : 0);
    });
    EXPECT_NEAR(*evaluate(s, all).designs[0].references[0].value, 10, 1e-9);
}

TEST_F(EvaluationTest, ANumberThatNobodyHasIsToldWithTheNearest) {
    const Study s = study({"parameters.mesh=1,2"}, {"peek"});
    const auto all = results(s, [](const StudyCase&, double, double) { return 1.0; });
    try {
        static_cast<void>(evaluate(s, all));
        FAIL();
    } catch (const UsageError& error) {
        EXPECT_THAT(error.what(), HasSubstr("the nearest is 'peak'"));
    }
}

TEST_F(EvaluationTest, SentencesCompareTheEndsOfAnAxis) {
    const Study s = study({"model.step.courant=0.5,0.1"}, {"peak=10"});
    const auto all = results(s, [](const StudyCase&, double, double dt) { return dt > 0.3 ? 10.1 : 10.4; });
    const auto said = conclusions(s, all, evaluate(s, all));
    ASSERT_EQ(said.size(), 2U);
    EXPECT_THAT(said[1], HasSubstr("At step 0.5 a run takes 2 s; errors: peak 1.00 %"));
    EXPECT_THAT(said[0],
                HasSubstr("step 0.5 of critical is nearer to the exact answer and 5.0 times cheaper"));
}

TEST_F(EvaluationTest, DifferencesBelowTheUncertaintyOfTheReferenceAreNotTold) {
    const Study s = study({"model.step.courant=0.5,0.1", "parameters.mesh=1,2,4"}, {"peak"});
    const auto all = results(s, [](const StudyCase&, double h, double dt) { return 10 + h + 0.01 * dt; });
    EXPECT_THAT(conclusions(s, all, evaluate(s, all))[0],
                HasSubstr("differ by less than the reference is certain to"));
}

}  // namespace
}  // namespace percuss::app
