#include "run/history.hpp"

#include <array>
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
    History history(three_columns());
    constexpr std::size_t total = 50'000;
    std::thread writer([&] { append_rows(history, static_cast<int>(total)); });
    std::array<int, 2> wrong{0, 0};
    std::array<std::thread, 2> readers;
    for (std::size_t r = 0; r < readers.size(); ++r) {
        readers[r] = std::thread([&history, &count = wrong[r]] {
            std::size_t seen = 0;
            while (seen < total) {
                const std::size_t rows = history.rows();
                const std::vector<double> table = history.table(seen, rows);
                for (std::size_t i = seen; i < rows; ++i) {
                    const double* row = table.data() + 3 * (i - seen);
                    const auto expected = static_cast<double>(i);
                    if (row[0] != 0.5 * expected || row[1] != -expected || row[2] != 2 * expected) ++count;
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

}  // namespace
}  // namespace percuss
