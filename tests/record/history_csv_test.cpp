#include <fstream>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "record/run_file.hpp"
#include "record/sample_run.hpp"

namespace percuss {
namespace {

std::vector<std::string> lines_of(const std::filesystem::path& file) {
    std::ifstream in(file);
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

TEST(HistoryCsv, CarriesUnitsAndEveryBit) {
    const test::TemporaryFolder folder;
    History history({{"time", Quantity::time},
                     {"contact.impact.axial", Quantity::force},
                     {"count", Quantity::dimensionless}});
    history.append(std::array{0.0, 1.0 / 3, 2.0});
    history.append(std::array{1e-300, -63.8, 3.0});
    write_history_csv(folder.path() / "history.csv", history, Units());
    const auto lines = lines_of(folder.path() / "history.csv");
    ASSERT_EQ(lines.size(), 3U);
    EXPECT_EQ(lines[0], "time [ms],contact.impact.axial [kN],count");
    EXPECT_EQ(lines[1], "0,0.33333333333333331,2");
    double time = 0, force = 0, count = 0;
    char comma = 0;
    std::istringstream(lines[2]) >> time >> comma >> force >> comma >> count;
    EXPECT_EQ(time, 1e-300);
    EXPECT_EQ(force, -63.8);
    EXPECT_EQ(count, 3);
}

TEST(HistoryCsv, KeepsEveryNthRow) {
    const test::TemporaryFolder folder;
    History history(test::sample_columns());
    test::append_sample_rows(history, 10);
    write_history_csv(folder.path() / "history.csv", history, Units(), 4);
    EXPECT_EQ(lines_of(folder.path() / "history.csv").size(), 1U + 3U);  // rows 0, 4, 8
}

TEST(HistoryCsv, QuotesNamesThatWouldShiftColumns) {
    const test::TemporaryFolder folder;
    History history({{"a,\"b\"", Quantity::dimensionless}, {"c", Quantity::dimensionless}});
    write_history_csv(folder.path() / "history.csv", history, Units());
    EXPECT_EQ(lines_of(folder.path() / "history.csv").front(), "\"a,\"\"b\"\"\",c");
}

TEST(HistoryCsv, SaysWhichFileCannotBeWritten) {
    const History history(test::sample_columns());
    EXPECT_THROW(write_history_csv("/dev/null/history.csv", history, Units()), RecordError);
}

}  // namespace
}  // namespace percuss
