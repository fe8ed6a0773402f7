#include "run/thinned_history.hpp"

#include <algorithm>
#include <atomic>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace percuss {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

using Numbers = ThinnedHistory<std::int64_t>;

void offer(Numbers& history, std::int64_t place, std::size_t bytes = 10) {
    if (!history.due(place)) return;
    history.add(place, static_cast<double>(place), std::make_shared<const std::int64_t>(place), bytes);
}

void force(Numbers& history, std::int64_t place) {
    history.set_newest(place, static_cast<double>(place), std::make_shared<const std::int64_t>(place), 10);
}

TEST(ThinnedHistory, KeepsEveryEntryOnTheGridWithinTheBound) {
    Numbers history(1000, 4);
    for (std::int64_t place = 0; place < 18; ++place) offer(history, place);
    EXPECT_THAT(history.times(), ElementsAre(0, 4, 8, 12, 16));
    EXPECT_EQ(history.bytes(), 50U);
}

TEST(ThinnedHistory, DropsEverySecondWhenTheBoundIsReached) {
    Numbers history(50, 1);
    for (std::int64_t place = 0; place < 5; ++place) offer(history, place);
    EXPECT_THAT(history.times(), ElementsAre(0, 1, 2, 3, 4)) << "just within";
    offer(history, 5);
    EXPECT_THAT(history.times(), ElementsAre(0, 2, 4, 5)) << "the newest stays";
    offer(history, 6);
    EXPECT_THAT(history.times(), ElementsAre(0, 2, 4, 6)) << "until the next one comes";
    for (std::int64_t place = 7; place < 1000; ++place) {
        offer(history, place);
        ASSERT_LE(history.bytes(), 50U);
        ASSERT_EQ(history.times().front(), 0);
        ASSERT_GE(history.times().size(), 3U) << place;
    }
    EXPECT_THAT(history.times(), ElementsAre(0, 256, 512, 768));
}

TEST(ThinnedHistory, TheFirstAndTheNewestOutliveAnyBound) {
    Numbers history(1, 1);
    for (std::int64_t place = 0; place <= 64; ++place) offer(history, place);
    EXPECT_EQ(history.times().front(), 0);
    EXPECT_EQ(history.times().size(), 2U);
    EXPECT_EQ(history.bytes(), 20U);
}

TEST(ThinnedHistory, AForcedNewestGivesWayToTheNext) {
    Numbers history(1000, 4);
    for (std::int64_t place = 0; place < 6; ++place) offer(history, place);
    force(history, 6);
    force(history, 7);
    EXPECT_THAT(history.times(), ElementsAre(0, 4, 7));
    force(history, 7);
    EXPECT_THAT(history.times(), ElementsAre(0, 4, 7)) << "once";
    offer(history, 8);
    EXPECT_THAT(history.times(), ElementsAre(0, 4, 8));
    force(history, 12);
    force(history, 13);
    EXPECT_THAT(history.times(), ElementsAre(0, 4, 8, 12, 13)) << "12 was due";
    force(history, 7);
    EXPECT_THAT(history.times(), ElementsAre(0, 4, 7)) << "what is not earlier goes";
    EXPECT_EQ(history.bytes(), 30U);
}

TEST(ThinnedHistory, FindsTheNewestThatIsNotLater) {
    Numbers history(1000, 4);
    EXPECT_EQ(history.at_or_before(1e9).first, nullptr);
    for (std::int64_t place = 0; place < 10; ++place) offer(history, place);
    EXPECT_EQ(history.at_or_before(-0.1).first, nullptr);
    EXPECT_EQ(*history.at_or_before(0).first, 0);
    EXPECT_EQ(*history.at_or_before(3.9).first, 0);
    EXPECT_EQ(*history.at_or_before(4).first, 4);
    EXPECT_EQ(history.at_or_before(7).second, 4);
    EXPECT_EQ(*history.at_or_before(1e9).first, 8);
}

TEST(ThinnedHistory, APartGoesOnByItself) {
    Numbers history(60, 2);
    for (std::int64_t place = 0; place < 11; ++place) offer(history, place);
    const auto part = history.up_to(6.5);
    EXPECT_THAT(part->times(), ElementsAre(0, 2, 4, 6));
    EXPECT_EQ(part->bytes(), 40U);
    EXPECT_FALSE(part->due(7));
    offer(*part, 8);
    offer(*part, 10);
    offer(*part, 12);
    EXPECT_THAT(part->times(), ElementsAre(0, 4, 8, 12)) << "the same bound and grid";
    EXPECT_THAT(history.times(), ElementsAre(0, 2, 4, 6, 8, 10));
    EXPECT_THAT(history.up_to(-1)->times(), IsEmpty());
}

TEST(ThinnedHistory, IsReadWhileItGrowsAndThins) {
    Numbers history(300, 1);
    std::atomic<bool> done{false};
    std::atomic<int> wrong{0};
    std::thread reader([&] {
        while (!done) {
            const auto times = history.times();
            if (!std::is_sorted(times.begin(), times.end()) || history.bytes() > 300) ++wrong;
            const auto [entry, time] = history.at_or_before(5000);
            if (entry && static_cast<double>(*entry) != time) ++wrong;
        }
    });
    for (std::int64_t place = 0; place < 20000; ++place) offer(history, place);
    done = true;
    reader.join();
    EXPECT_EQ(wrong, 0);
}

}  // namespace
}  // namespace percuss
