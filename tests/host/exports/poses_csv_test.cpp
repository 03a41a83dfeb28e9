// SPDX-License-Identifier: MIT
#include "host/exports/poses_csv.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/exports/points_csv.hpp"
#include "host/files/atomic_file.hpp"
#include "tests/support/run_tables.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/thrown_text.hpp"

namespace echomap::exports {
namespace {

using ::testing::HasSubstr;

TEST(PosesCsv, ReloadsToTheSamePosesToTheLastBit) {
  const tests::ScratchFolder folder;
  std::vector<geometry::Pose2> poses;
  for (int i = 0; i < 100; ++i) {
    poses.emplace_back(i / 7.0, -i / 11.0, i / 3.0);
  }
  write_poses_csv(folder / "poses.csv", poses);
  const auto read = tests::read_poses_csv(folder / "poses.csv");
  ASSERT_EQ(read.size(), poses.size());
  for (std::size_t i = 0; i < poses.size(); ++i) {
    EXPECT_EQ(read[i].position_m(), poses[i].position_m());
    EXPECT_EQ(read[i].heading_rad(), poses[i].heading_rad());
  }
}

TEST(PointCloudMap, ReloadsFromItsTwoMatrices) {
  const tests::ScratchFolder folder;
  mapping::PointCloudMap map;
  for (int i = 0; i < 50; ++i) {
    const geometry::Pose2 pose(0.1 * (i / 5), 0.0, 0.2 * (i / 5));
    map.add({pose, pose * geometry::Pose2(0.03, 0.0, 0.1 * i), 0.5 + i / 30.0});
  }
  write_points_csv(folder / "points.csv", map.points());
  write_poses_csv(folder / "poses.csv", map.poses());
  const auto read = tests::read_point_cloud_map(folder.path());
  ASSERT_EQ(read.poses().size(), map.poses().size());
  ASSERT_EQ(read.points().size(), map.points().size());
  for (std::size_t i = 0; i < map.points().size(); ++i) {
    EXPECT_EQ(read.points()[i].position_m, map.points()[i].position_m);
    EXPECT_EQ(read.points()[i].pose_index, map.points()[i].pose_index);
  }
}

TEST(PointCloudMap, IsNotReadWhereAPointNamesNoPose) {
  const tests::ScratchFolder folder;
  write_points_csv(folder / "points.csv", {{{0.0, 0.0}, 3}});
  write_poses_csv(folder / "poses.csv", {geometry::Pose2()});
  EXPECT_THAT(
      tests::thrown_text<files::FileError>([&] { tests::read_point_cloud_map(folder.path()); }),
      HasSubstr("points.csv"));
}

}  // namespace
}  // namespace echomap::exports
