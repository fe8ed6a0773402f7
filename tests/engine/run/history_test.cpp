#include "run/history.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace percuss {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::vector<HistoryColumn> three_columns() {
    return {
        {"time", Quantity::time}, {"contact.impact.axial", Quantity::force}, {"double", Quantity::length}};
}

void append_rows(History& history, int count) {
    for (int i = 0; i < count; ++i) {
        const std::array<double, 3> row{i * 0.5, -1.0 * i, 2.0 * i};
        history.append(row);
    }
}

TEST(History, KeepsRowsOverBlockBorders) {
    History history(three_columns());
    append_rows(history, 3000);  // blocks hold 1024 rows
    ASSERT_EQ(history.rows(), 3000U);
    EXPECT_THAT(history.values(2, 1022, 1026), ElementsAre(2044, 2046, 2048, 2050));
    EXPECT_THAT(history.table(2047, 2049), ElementsAre(1023.5, -2047, 4094, 1024, -2048, 4096));
    const std::vector<double> time = history.values("time");
    ASSERT_EQ(time.size(), 3000U);
    EXPECT_EQ(time.back(), 1499.5);
    EXPECT_TRUE(history.values(0, 5, 5).empty());
}

TEST(History, ABranchSharesTheFirstRowsAndGoesItsOwnWay) {
    for (const std::size_t rows : {0U, 1U, 1023U, 1024U, 1025U, 2048U, 3000U}) {
        History history(three_columns());
        append_rows(history, 3000);
        const std::vector<double> whole = history.table(0, 3000);
        const auto branch = history.first(rows);
        ASSERT_EQ(branch->rows(), rows);
        EXPECT_EQ(branch->table(0, rows), history.table(0, rows));
        for (int k = 0; k < 2000; ++k) branch->append(std::array<double, 3>{-1, -2, -3});
        EXPECT_EQ(history.table(0, 3000), whole) << rows;
        history.append(std::array<double, 3>{7, 8, 9});
        EXPECT_THAT(branch->table(rows, rows + 1), ElementsAre(-1, -2, -3));
        EXPECT_THAT(branch->table(rows + 1999, rows + 2000), ElementsAre(-1, -2, -3));
        EXPECT_EQ(branch->table(0, rows),
                  std::vector<double>(whole.begin(), whole.begin() + 3 * static_cast<std::ptrdiff_t>(rows)));
    }
}

constexpr std::size_t block_bytes = 1024 * 3 * sizeof(double);

/// Chatter whose height is its row, but for a spike.
void append_chatter(History& history, std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i) {
        const auto k = static_cast<double>(i);
        history.append(std::array<double, 3>{0.5 * k, i % 2 == 0 ? k : -k, i == 1234 ? 1e6 : 1.0});
    }
}

TEST(History, WithinABoundOldRowsKeepTheirLeastAndGreatest) {
    History history(three_columns(), 8 * block_bytes);
    constexpr std::size_t rows = 64 * 1024 + 10;
    append_chatter(history, 0, rows);
    ASSERT_EQ(history.rows(), rows);
    // Four blocks as they were, and the one that is being filled; 16 of two blocks' bytes ...
    EXPECT_EQ(history.thinned_rows(), 60U * 1024);
    EXPECT_EQ(history.grain(60 * 1024), 1U);
    EXPECT_EQ(history.grain(60 * 1024 - 1), 16U);
    EXPECT_EQ(history.grain(43 * 1024), 128U);
    EXPECT_EQ(history.grain(0), 128U);
    EXPECT_THAT(history.table(rows - 1, rows), ElementsAre(0.5 * (rows - 1), -1.0 * (rows - 1), 1.0));
    const std::vector<double> time = history.values("time"), force = history.values(1, 0, rows),
                              spike = history.values(2, 0, rows);
    for (std::size_t k = 0; k < rows; ++k) ASSERT_NEAR(time[k], 0.5 * static_cast<double>(k), 1e-6);
    for (std::size_t group = 0; group + 128 <= rows; group += 128) {
        const auto begin = force.begin() + static_cast<std::ptrdiff_t>(group);
        const auto [low, high] = std::minmax_element(begin, begin + 128);
        EXPECT_EQ(*low, -static_cast<double>(group + 127));
        EXPECT_EQ(*high, static_cast<double>(group + 126));
    }
    EXPECT_EQ(*std::max_element(spike.begin(), spike.end()), 1e6);
    EXPECT_EQ(*std::max_element(spike.begin() + 1280, spike.end()), 1);
}

TEST(History, ABranchOfAThinnedOneSaysWhatIsThinned) {
    History history(three_columns(), 4 * block_bytes);
    append_chatter(history, 0, 20 * 1024);
    for (const std::size_t rows : {5U * 1024U, 5U * 1024U + 100U, 20U * 1024U - 5U}) {
        const auto branch = history.first(rows);
        EXPECT_EQ(branch->thinned_rows(), std::min(rows, history.thinned_rows()));
        EXPECT_EQ(branch->table(0, rows), history.table(0, rows));
        append_chatter(*branch, rows, 40 * 1024);
        EXPECT_GT(branch->thinned_rows(), 30U * 1024);
        const std::vector<double> time = branch->values("time");
        EXPECT_TRUE(std::is_sorted(time.begin(), time.end()));
        const std::vector<double> spike = branch->values(2, 0, 40 * 1024);
        EXPECT_EQ(*std::max_element(spike.begin(), spike.end()), 1e6);
    }
}

TEST(History, WithoutABoundNothingIsThinned) {
    History history(three_columns());
    append_chatter(history, 0, 20 * 1024);
    EXPECT_EQ(history.thinned_rows(), 0U);
    EXPECT_EQ(history.grain(0), 1U);
}

TEST(History, NamesTheNearestColumn) {
    const History history(three_columns());
    EXPECT_EQ(history.column("contact.impact.axial"), 1U);
    try {
        static_cast<void>(history.column("contact.impact.axail"));
        FAIL() << "an unknown column was found";
    } catch (const std::invalid_argument& error) {
        EXPECT_THAT(error.what(), HasSubstr("no history column 'contact.impact.axail'"));
        EXPECT_THAT(error.what(), HasSubstr("contact.impact.axial"));
    }
}

// Each row is consistent whenever it is visible; run under ThreadSanitizer this also proves the absence of
// races.
TEST(History, ReadersSeeOnlyCompleteRowsWhileOneThreadAppends) {
    // The bound is that of the whole: blocks are thinned as soon as the next one begins, under their readers.
    for (const std::size_t memory : {std::size_t{0}, 4 * block_bytes}) {
        History history(three_columns(), memory);
        constexpr std::size_t total = 50'000;
        std::thread writer([&] { append_rows(history, static_cast<int>(total)); });
        std::array<int, 2> wrong{0, 0};
        std::array<std::thread, 2> readers;
        for (std::size_t r = 0; r < readers.size(); ++r) {
            readers[r] = std::thread([&history, &count = wrong[r], memory] {
                std::size_t seen = 0;
                while (seen < total) {
                    const std::size_t rows = history.rows();
                    const std::vector<double> table = history.table(seen, rows);
                    for (std::size_t i = seen; i < rows; ++i) {
                        const double* row = table.data() + 3 * (i - seen);
                        const auto expected = static_cast<double>(i);
                        const double apart = memory > 0 ? 1024 : 0;  // thinned meanwhile
                        if (std::abs(row[0] - 0.5 * expected) > 1e-6 * apart ||
                            std::abs(row[1] + expected) > apart ||
                            std::abs(row[2] - 2 * expected) > 2 * apart)
                            ++count;
                    }
                    seen = rows;
                    std::this_thread::yield();
                }
            });
        }
        writer.join();
        for (std::thread& reader : readers) reader.join();
        EXPECT_THAT(wrong, ElementsAre(0, 0));
    }
}

}  // namespace
}  // namespace percuss
