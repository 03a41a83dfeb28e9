// SPDX-License-Identifier: MIT
#include "host/exports/grid_csv.hpp"

#include <random>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/files/atomic_file.hpp"
#include "tests/support/run_tables.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/thrown_text.hpp"

namespace echomap::exports {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::StartsWith;

TEST(OccupancyGridCsv, BeginsAtTheTopAndMarksTheUnknown) {
  const tests::ScratchFolder folder;
  mapping::OccupancyGrid grid;
  grid.add({-2, 0}, -110);
  grid.add({0, 1}, 300);
  write_occupancy_grid_csv(folder / "grid.csv", grid);
  const std::string text = files::read_text_file(folder / "grid.csv");
  EXPECT_THAT(text, StartsWith("# resolution_m,origin_x_m,origin_y_m,rows,columns; "));
  EXPECT_THAT(text,
              EndsWith("\n# 0.05,-0.1,0,2,3\n"
                       "-1,-1,0.9526\n"
                       "0.2497,-1,-1\n"));
}

TEST(OccupancyGridCsv, OfNothingIsOneUnknownCell) {
  const tests::ScratchFolder folder;
  write_occupancy_grid_csv(folder / "grid.csv", mapping::OccupancyGrid());
  EXPECT_THAT(files::read_text_file(folder / "grid.csv"), EndsWith("\n# 0.05,0,0,1,1\n-1\n"));
}

TEST(OccupancyGridCsv, ReadsBackTheSameProbabilities) {
  const tests::ScratchFolder folder;
  std::mt19937 random(1);
  mapping::OccupancyGrid grid;
  for (int i = 0; i < 400; ++i) {
    grid.add({static_cast<int>(random() % 30) - 15, static_cast<int>(random() % 20) - 5},
             static_cast<int>(random() % 800) - 400);
  }
  write_occupancy_grid_csv(folder / "grid.csv", grid);
  const auto table = tests::read_occupancy_grid_csv(folder / "grid.csv");
  EXPECT_EQ(table.resolution_m, 0.05);
  EXPECT_EQ(table.columns, grid.bounds().columns());
  EXPECT_EQ(table.rows, grid.bounds().rows());
  const auto low = grid.bounds().min;
  EXPECT_NEAR(table.origin_m.x(), low.x * 0.05, 1e-12);
  EXPECT_NEAR(table.origin_m.y(), low.y * 0.05, 1e-12);
  int known = 0;
  for (int row = -1; row <= table.rows; ++row) {
    for (int column = -1; column <= table.columns; ++column) {
      const auto expected = grid.probability({low.x + column, low.y + row});
      const auto read = table.at(column, row);
      ASSERT_EQ(read.has_value(), expected.has_value()) << column << " " << row;
      if (read) {
        EXPECT_NEAR(*read, *expected, 5e-5);
        ++known;
      }
    }
  }
  EXPECT_GT(known, 200);
}

TEST(OccupancyGridCsv, SaysWhichLineIsWrong) {
  const tests::ScratchFolder folder;
  const auto complaint_about = [&](const std::string& text) {
    files::write_text_file(folder / "a.csv", text);
    return tests::thrown_text<files::FileError>(
        [&] { tests::read_occupancy_grid_csv(folder / "a.csv"); });
  };
  const std::string names = "# resolution_m,origin_x_m,origin_y_m,rows,columns\n";
  EXPECT_THAT(complaint_about(""), HasSubstr("a.csv:1: "));
  EXPECT_THAT(complaint_about("0.5,0.5\n"), HasSubstr("a.csv:1: "));
  EXPECT_THAT(complaint_about(names + "# 0.05,0,0,1\n"), HasSubstr("a.csv:2: expected 5"));
  EXPECT_THAT(complaint_about(names + "# 0.05,0,0,1,1e99\n"), HasSubstr("a.csv:2: "));
  EXPECT_THAT(complaint_about(names + "# -1,0,0,1,1\n-1\n"), HasSubstr("a.csv:2: "));
  EXPECT_THAT(complaint_about(names + "# 1,0,0,3,1\n-1\n"), HasSubstr("a.csv:2: "));
  EXPECT_THAT(complaint_about(names + "# 1,0,0,1,2\n-1\n"), HasSubstr("a.csv:3: expected 2"));
  EXPECT_THAT(complaint_about(names + "# 1,0,0,1,1\n1.5\n"), HasSubstr("a.csv:3: a cell"));
  EXPECT_THAT(complaint_about(names + "# 1,0,0,1,1\n-0.5\n"), HasSubstr("a.csv:3: a cell"));
}

TEST(ConfidenceGridCsv, BeginsAtTheTop) {
  const tests::ScratchFolder folder;
  mapping::CellField confidence({{-1, 0}, {1, 1}}, 0.05);
  confidence[confidence.index({-1, 0})] = 1.0F;
  confidence[confidence.index({1, 1})] = 12.60653F;
  write_confidence_grid_csv(folder / "grid.csv", confidence);
  const std::string text = files::read_text_file(folder / "grid.csv");
  EXPECT_THAT(text, StartsWith("# resolution_m,origin_x_m,origin_y_m,rows,columns; "));
  EXPECT_THAT(text,
              EndsWith("\n# 0.05,-0.05,0,2,3\n"
                       "0,0,12.6065\n"
                       "1,0,0\n"));
}

}  // namespace
}  // namespace echomap::exports
