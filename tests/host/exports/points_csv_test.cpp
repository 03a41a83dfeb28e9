// SPDX-License-Identifier: MIT
#include "host/exports/points_csv.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/files/atomic_file.hpp"
#include "tests/support/run_tables.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/thrown_text.hpp"

namespace echomap::exports {
namespace {

using ::testing::HasSubstr;

TEST(PointsCsv, ReloadsToTheSamePoints) {
  const tests::ScratchFolder folder;
  std::vector<mapping::MapPoint> points;
  for (std::size_t i = 0; i < 200; ++i) {
    const double number = static_cast<double>(i);
    points.push_back({{number / 7.0, -number / 3.0}, i / 9});
  }
  write_points_csv(folder / "points.csv", points);
  const auto read = tests::read_points_csv(folder / "points.csv");
  ASSERT_EQ(read.size(), points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(read[i].position_m, points[i].position_m);
    EXPECT_EQ(read[i].pose_index, points[i].pose_index);
  }
}

TEST(PointsCsv, OfNoPointsIsAHeader) {
  const tests::ScratchFolder folder;
  write_points_csv(folder / "points.csv", {});
  EXPECT_EQ(files::read_text_file(folder / "points.csv"), "x_m,y_m,pose_index\n");
  EXPECT_TRUE(tests::read_points_csv(folder / "points.csv").empty());
}

TEST(PointsCsv, RefusesAnIndexThatIsNone) {
  const tests::ScratchFolder folder;
  for (const char* index : {"-1", "0.5", "1e300"}) {
    files::write_text_file(
        folder / "points.csv",
        "# a room\nx_m,y_m,pose_index\n0,0,0\n# moved\n1,2," + std::string(index) + "\n");
    EXPECT_THAT(tests::thrown_text<files::FileError>(
                    [&] { tests::read_points_csv(folder / "points.csv"); }),
                HasSubstr("points.csv:5: pose_index"));
  }
}

}  // namespace
}  // namespace echomap::exports
