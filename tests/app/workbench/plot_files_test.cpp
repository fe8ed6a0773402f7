#include "workbench/export/plot_files.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/program_test.hpp"

namespace percuss::app {
namespace {

class PlotFilesTest : public test::ProgramTest {};

TEST_F(PlotFilesTest, AThinnedRunSaysWhatItsRowsAre) {
    auto history = std::make_shared<History>(
        std::vector<HistoryColumn>{{"time", Quantity::time}, {"contact.a.x", Quantity::force}},
        std::size_t{4} * 1024 * 2 * sizeof(double));
    constexpr std::size_t rows = 3 * 1024 + 5;
    for (std::size_t i = 0; i < rows; ++i)
        history->append(std::array{0.5 * static_cast<double>(i), i == 99 ? 1e6 : i % 2 == 0 ? 1.0 : -1.0});
    ASSERT_EQ(history->thinned_rows(), 1024U);
    PlotContents contents{{"forces", "force", Quantity::force, {{1, "a"}}}, Units{}, 1, {0, 1e9}, {}};
    contents.runs.push_back({history, "", 0, rows, {1}, {0}});
    write_plot_csv(path("thinned.csv"), contents);
    std::istringstream lines(test::text_of(path("thinned.csv")));
    std::string line;
    std::getline(lines, line);
    EXPECT_THAT(line, testing::EndsWith(",what the row is"));
    std::vector<std::string> all;
    while (std::getline(lines, line)) all.push_back(line);
    ASSERT_EQ(all.size(), 2 * 1024 / 16 + rows - 1024);
    EXPECT_EQ(all[0], "0,-1,least of 16 steps");
    EXPECT_EQ(all[1], "4,1,greatest of 16 steps");
    EXPECT_EQ(all[13], "52,1000000,greatest of 16 steps");
    EXPECT_EQ(all[128], "512,1,step");
    EXPECT_EQ(all.back(), "1538,1,step");

    // Where nothing is thinned the file is a plain table.
    contents.runs[0].begin = 1024;
    write_plot_csv(path("newest.csv"), contents);
    EXPECT_THAT(test::text_of(path("newest.csv")), testing::Not(testing::HasSubstr("what the row is")));
    EXPECT_EQ(figure_of(contents, "").charts.at(0).title, "");

    contents.runs[0].begin = 0;
    EXPECT_EQ(figure_of(contents, "").charts.at(0).title,
              "until 512 ms the least and greatest of every few steps");
    contents.runs.push_back({history, "reference ", 1024, rows, {1}, {0}});
    contents.thinned_before = 1000;
    EXPECT_EQ(figure_of(contents, "").charts.at(0).title,
              "dashed: the reference; until 1000 ms the least and greatest of every few steps");
}

}  // namespace
}  // namespace percuss::app
