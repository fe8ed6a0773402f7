#include "study/pareto.hpp"

#include <array>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace percuss::app {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(Pareto, NobodyBeatsWhoIsOnTheFront) {
    const std::array<Offer, 6> offers{{{3, 0.1}, {1, 0.5}, {2, 0.5}, {2, 0.2}, {1, {}}, {4, 0.3}}};
    EXPECT_THAT(pareto_front(offers), ElementsAre(1, 3, 0));
    EXPECT_THAT(pareto_front({}), IsEmpty());
}

TEST(Pareto, AsTheDefinitionHasIt) {
    std::mt19937 random(5);
    std::uniform_int_distribution<int> few(1, 6);
    for (int trial = 0; trial < 200; ++trial) {
        std::vector<Offer> offers(8);
        for (Offer& offer : offers)
            offer = {static_cast<double>(few(random)), static_cast<double>(few(random))};
        const auto front = pareto_front(offers);
        for (std::size_t i = 0; i < offers.size(); ++i) {
            bool beaten = false, twin = false;
            for (std::size_t j = 0; j < offers.size(); ++j) {
                if (i == j) continue;
                const bool no_worse =
                    offers[j].price <= offers[i].price && *offers[j].error <= *offers[i].error;
                const bool better = offers[j].price < offers[i].price || *offers[j].error < *offers[i].error;
                beaten = beaten || (no_worse && better);
                twin = twin || (no_worse && !better && j < i);
            }
            const bool on = std::find(front.begin(), front.end(), i) != front.end();
            EXPECT_EQ(on, !beaten && !twin);
        }
    }
}

TEST(Pareto, TheCheapestThatIsNearEnough) {
    const std::array<Offer, 4> offers{{{3, 0.01}, {1, 0.5}, {2, 0.05}, {0.5, {}}}};
    EXPECT_EQ(cheapest_within(offers, 0.05), 2U);
    EXPECT_EQ(cheapest_within(offers, 0.02), 0U);
    EXPECT_FALSE(cheapest_within(offers, 0.001));
}

}  // namespace
}  // namespace percuss::app
