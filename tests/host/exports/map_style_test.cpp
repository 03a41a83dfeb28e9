// SPDX-License-Identifier: MIT
#include "host/exports/map_style.hpp"

#include <cmath>
#include <memory>

#include <gtest/gtest.h>

#include "tests/support/told_snapshot.hpp"

namespace echomap::exports {
namespace {

std::vector<std::string> texts_of(const std::vector<LegendEntry>& legend) {
  std::vector<std::string> texts;
  for (const LegendEntry& entry : legend) {
    texts.push_back(entry.text);
  }
  return texts;
}

pipeline::Snapshot with_features(mapping::SonarFeatures features) {
  pipeline::Snapshot snapshot = tests::snapshot_of(mapping::OccupancyGrid());
  snapshot.features = std::make_shared<const mapping::SonarFeatures>(std::move(features));
  return snapshot;
}

TEST(LegendOf, ASnapshotOfNothingHasTheCellsAndTheRobot) {
  const auto legend = legend_of(tests::snapshot_of(mapping::OccupancyGrid()), false, {});
  EXPECT_EQ(texts_of(legend), (std::vector<std::string>{"floor", "occupied", "unknown", "robot"}));
  EXPECT_EQ(legend.front().colour, kFloorColour);
  EXPECT_EQ(legend.back().colour, kRobotColour);
}

TEST(LegendOf, NamesEchoesAndTrailWhereThereAreAny) {
  mapping::PointCloudMap points;
  points.add({geometry::Pose2(), geometry::Pose2(), 0.75});
  const auto snapshot =
      tests::snapshot_of(mapping::OccupancyGrid(), {tests::pose_at(0, {})}, points);
  EXPECT_EQ(texts_of(legend_of(snapshot, false, {})),
            (std::vector<std::string>{
                "floor", "occupied", "unknown", "echo", "trail", "start", "robot"}));
}

TEST(LegendOf, NamesFittedWallsAndCirclesIfTheyAreShown) {
  const std::vector<std::string> fitted{"floor", "occupied", "unknown", "fitted", "robot"};
  const auto wall = with_features({{{{0, 0}, {1, 0}}}, {}});
  EXPECT_EQ(texts_of(legend_of(wall, false, {})), fitted);
  EXPECT_EQ(texts_of(legend_of(with_features({{}, {{{1, 1}, 0.1, {}}}}), false, {})), fitted);
  MapStyle style;
  style.shows_features = false;
  EXPECT_EQ(legend_of(wall, false, style).size(), 4U);
}

TEST(LegendOf, NamesLandmarksIfThereAreAny) {
  MapStyle style;
  style.landmarks.walls = {{{0.0, 0.0}, {1.0, 0.0}}};
  EXPECT_EQ(texts_of(legend_of(tests::snapshot_of(mapping::OccupancyGrid()), false, style)),
            (std::vector<std::string>{"floor", "occupied", "unknown", "landmark", "robot"}));
}

TEST(LegendOf, NamesTheOutlineIfThereIsOne) {
  EXPECT_EQ(texts_of(legend_of(tests::snapshot_of(mapping::OccupancyGrid()), true, {})),
            (std::vector<std::string>{"floor", "occupied", "unknown", "outline", "robot"}));
}

TEST(HeldPoints, HoldTheRobotHoweverThePictureIsTurned) {
  auto snapshot = tests::snapshot_of(mapping::OccupancyGrid());
  snapshot.latest = tests::pose_at(0, {1.0, 2.0, 0.5});
  const auto points_m = held_points_m(snapshot, {.robot_radius_m = 0.1});
  ASSERT_EQ(points_m.size(), 4U);
  for (const Eigen::Vector2d& point_m : points_m) {
    const Eigen::Vector2d from_robot_m = point_m - Eigen::Vector2d(1.0, 2.0);
    EXPECT_NEAR(std::abs(from_robot_m.x()), 0.15, 1e-12);
    EXPECT_NEAR(std::abs(from_robot_m.y()), 0.15, 1e-12);
  }
  EXPECT_NEAR((points_m[0] - points_m[3]).norm(), 0.3 * std::sqrt(2.0), 1e-12);
}

TEST(HeldPoints, HoldEveryPoseOfTheTrail) {
  const auto snapshot = tests::snapshot_of(
      mapping::OccupancyGrid(), {tests::pose_at(0, {-3.0, 0.0, 0.0}), tests::pose_at(1, {})});
  const auto points_m = held_points_m(snapshot, {.robot_radius_m = 0.0});
  // The last pose is the robot's, too.
  ASSERT_EQ(points_m.size(), 12U);
  EXPECT_EQ(points_m.front(), Eigen::Vector2d(-3.0, 0.0));
  EXPECT_EQ(points_m.back(), Eigen::Vector2d(0.0, 0.0));
}

TEST(HeldPoints, AreTheEchoesOfAMapOfPointsToo) {
  mapping::PointCloudMap points;
  points.add({geometry::Pose2(), geometry::Pose2(), 2.5});
  const auto snapshot = tests::snapshot_of(mapping::OccupancyGrid(), {}, points);
  EXPECT_EQ(held_points_m(snapshot, {}).size(), 4U);
  const auto points_m = held_points_m(snapshot, {.holds_echoes = true});
  ASSERT_EQ(points_m.size(), 5U);
  EXPECT_EQ(points_m.back(), Eigen::Vector2d(2.5, 0.0));
}

}  // namespace
}  // namespace echomap::exports
