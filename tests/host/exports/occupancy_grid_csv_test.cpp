// SPDX-License-Identifier: MIT
#include "host/exports/occupancy_grid_csv.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/files/atomic_file.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::exports {
namespace {

using ::testing::EndsWith;
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

}  // namespace
}  // namespace echomap::exports
