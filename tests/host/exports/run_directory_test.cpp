// SPDX-License-Identifier: MIT
#include "host/exports/run_directory.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/exports/geojson.hpp"
#include "host/exports/grid_csv.hpp"
#include "host/exports/pgm_yaml.hpp"
#include "host/exports/png_text.hpp"
#include "host/exports/poses_csv.hpp"
#include "host/exports/trajectory_tum.hpp"
#include "host/files/atomic_file.hpp"
#include "tests/support/drawn_map.hpp"
#include "tests/support/png_texts.hpp"
#include "tests/support/run_tables.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/told_snapshot.hpp"

namespace echomap::exports {
namespace {

using ::testing::UnorderedElementsAre;

pipeline::Snapshot short_run() {
  mapping::OccupancyGrid grid;
  grid.add({0, 0}, -300);
  grid.add({1, 0}, -300);
  grid.add({2, 0}, 300);
  mapping::PointCloudMap points;
  points.add({geometry::Pose2(), geometry::Pose2(), 0.12});
  auto snapshot = tests::snapshot_of(
      grid, {tests::pose_at(0.0, {}), tests::pose_at(1.0, {0.3, 0.4, 0.0})}, points);
  snapshot.stops = 2;
  return snapshot;
}

std::vector<std::string> names_in(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    names.push_back(entry.path().filename().string());
  }
  return names;
}

TEST(RunDirectory, HoldsEveryFileAndNothingElse) {
  const tests::ScratchFolder folder;
  write_run_directory(folder / "a/b", short_run(), {});
  EXPECT_THAT(names_in(folder / "a/b"),
              UnorderedElementsAre("map.pgm",
                                   "map.yaml",
                                   "map.png",
                                   "map.svg",
                                   "occupancy_grid.csv",
                                   "outline.geojson",
                                   "points.csv",
                                   "poses.csv",
                                   "summary.json",
                                   "trajectory.tum"));
}

TEST(RunDirectory, ReloadsToTheSameMap) {
  const tests::ScratchFolder folder;
  write_run_directory(folder.path(), short_run(), {});
  EXPECT_EQ(tests::drawing_of(read_pgm_yaml(folder / "map.yaml")),
            (tests::DrawnMap{"     ", " ..# ", "     "}));
  EXPECT_EQ(tests::read_point_cloud_map(folder.path()).points().size(), 1U);
  EXPECT_EQ(read_trajectory_tum(folder / "trajectory.tum").size(), 2U);
  EXPECT_NEAR(read_outline_geojson(folder / "outline.geojson")->area_m2(), 0.005, 1e-12);
  const auto table = tests::read_occupancy_grid_csv(folder / "occupancy_grid.csv");
  EXPECT_GT(table.at(2, 0).value(), 0.65);
  EXPECT_EQ(tests::read_png_texts(folder / "map.png").size(), 3U);
}

TEST(RunDirectory, WritesTheSameBytesAgain) {
  const tests::ScratchFolder folder;
  write_run_directory(folder / "a", short_run(), {});
  write_run_directory(folder / "b", short_run(), {});
  for (const auto& name : names_in(folder / "a")) {
    EXPECT_EQ(files::read_text_file(folder / ("a/" + name)),
              files::read_text_file(folder / ("b/" + name)))
        << name;
  }
}

TEST(RunDirectory, OfARunThatHasNotBegunIsWritten) {
  const tests::ScratchFolder folder;
  write_run_directory(folder.path(), tests::snapshot_of(mapping::OccupancyGrid()), {});
  EXPECT_EQ(names_in(folder.path()).size(), 10U);
}

TEST(RunDirectory, SaysWhereItCannotBeMade) {
  const tests::ScratchFolder folder;
  files::write_text_file(folder / "file", "");
  EXPECT_THROW(write_run_directory(folder / "file/run", short_run(), {}), files::FileError);
}

TEST(DescribeSnapshot, CountsAndMeasures) {
  RunSummary summary;
  describe_snapshot(short_run(), summary);
  EXPECT_EQ(summary.stops, 2U);
  EXPECT_EQ(summary.poses, 1U);
  EXPECT_EQ(summary.points, 1U);
  EXPECT_NEAR(summary.travelled_m, 0.5, 1e-12);
  EXPECT_NEAR(summary.free_area_m2, 0.005, 1e-12);
}

TEST(DescribeSnapshot, CountsWhatTheWheelsDroveAndNotWhereSomebodyHasCarriedTheRobot) {
  auto run = tests::snapshot_of(mapping::OccupancyGrid(),
                                {tests::pose_at(0.0, {}),
                                 tests::pose_at(1.0, {0.3, 0.4, 0.0}),
                                 tests::pose_at(3.0, {3.0, 4.0, 0.0}),
                                 tests::pose_at(4.0, {3.0, 4.25, 0.0})});
  RunSummary summary;
  run.carried_to = {0, 2};
  describe_snapshot(run, summary);
  EXPECT_NEAR(summary.travelled_m, 0.75, 1e-12);
}

TEST(RunDirectory, SaysHowWellThePoseIsKnown) {
  RunSummary summary;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();
  covariance.diagonal() << 9e-4, 16e-4, 1.0;
  describe_uncertainty(covariance, summary);
  EXPECT_NEAR(summary.pose_stddev_m.value(), 0.05, 1e-9);
  EXPECT_NEAR(summary.pose_stddev_deg.value(), 57.2958, 1e-3);
}

}  // namespace
}  // namespace echomap::exports
