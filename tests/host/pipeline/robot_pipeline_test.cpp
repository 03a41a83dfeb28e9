// SPDX-License-Identifier: MIT
#include "host/pipeline/robot_pipeline.hpp"

#include <numbers>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"
#include "host/mapping/raster_map.hpp"
#include "tests/host/pipeline/moved_aside.hpp"
#include "tests/host/pipeline/plain_robot.hpp"
#include "tests/support/drawn_map.hpp"
#include "tests/support/robot_times.hpp"

namespace echomap::pipeline {
namespace {

using tests::at_us;

/// Wheel travel after driving `ahead_m` and then turning on the spot.
sensors::WheelTravel travel(double ahead_m, double turn_rad) {
  return {ahead_m - 0.1 * turn_rad, ahead_m + 0.1 * turn_rad};
}

/// A pipeline of which the test tells the story.
class RobotPipelineTest : public ::testing::Test {
 protected:
  void read(const sensors::WheelTravel& at, double pan_deg, std::optional<double> range_m) {
    stamp_us += 50'000;
    pipeline.on_sonar({at_us(stamp_us), at, geometry::radians(pan_deg), range_m});
  }

  /// A half turn of readings, all about as far, from where the wheels have brought the robot.
  void sweep(const sensors::WheelTravel& at, double range_m) {
    for (int pan_deg = -90; pan_deg < 90; pan_deg += 6) {
      read(at, pan_deg, range_m + (pan_deg % 4 == 0 ? 0.006 : 0.0));
    }
  }

  /// In a round room.
  void scan(double ahead_m, double range_m) {
    pipeline.begin_scan();
    for (const double turn_rad : {0.0, std::numbers::pi}) {
      sweep(travel(ahead_m, turn_rad), range_m);
      sweep(travel(ahead_m, turn_rad), range_m);
    }
    pipeline.end_scan();
  }

  RobotPipeline pipeline{plain_robot()};
  std::int64_t stamp_us = 0;
};

TEST_F(RobotPipelineTest, StartsAtTheOriginWithNothing) {
  const Snapshot snapshot = pipeline.snapshot();
  EXPECT_EQ(snapshot.latest.T_map_robot.position_m(), Eigen::Vector2d(0.0, 0.0));
  EXPECT_TRUE(snapshot.trajectory->empty());
  EXPECT_TRUE(snapshot.points->points().empty());
  EXPECT_TRUE(snapshot.last_scan->empty());
  EXPECT_TRUE(snapshot.grid->bounds().empty());
  EXPECT_EQ(snapshot.stops, 0U);
}

TEST_F(RobotPipelineTest, LeavesASnapshotThatIsHeldAsItIs) {
  read(travel(0.0, 0.0), 0.0, 1.0);
  const Snapshot before = pipeline.snapshot();
  scan(0.5, 1.0);
  EXPECT_EQ(before.trajectory->size(), 1U);
  EXPECT_EQ(before.points->points().size(), 1U);
  EXPECT_GT(pipeline.snapshot().trajectory->size(), 1U);
  EXPECT_GT(pipeline.snapshot().points->points().size(), 1U);
}

TEST_F(RobotPipelineTest, FollowsTheWheels) {
  pipeline.on_odometry({at_us(1000), travel(0.5, 0.0)});
  pipeline.on_odometry({at_us(2000), travel(0.5, geometry::radians(90.0))});
  pipeline.on_odometry({at_us(3000), travel(0.8, geometry::radians(90.0))});
  const Snapshot snapshot = pipeline.snapshot();
  ASSERT_EQ(snapshot.trajectory->size(), 3U);
  EXPECT_EQ(snapshot.latest.stamp, at_us(3000));
  EXPECT_NEAR(
      (snapshot.latest.T_map_robot.position_m() - Eigen::Vector2d(0.5, 0.3)).norm(), 0.0, 1e-9);
}

TEST_F(RobotPipelineTest, GoesOnFromWhereItIsSeen) {
  pipeline.on_odometry({at_us(1000), travel(1.0, 0.0)});
  pipeline.on_pose_fix({at_us(1000), {2.0, 3.0, geometry::radians(90.0)}});
  EXPECT_EQ(pipeline.snapshot().latest.T_map_robot.x_m(), 2.0);
  pipeline.on_odometry({at_us(2000), travel(1.5, 0.0)});
  const auto snapshot = pipeline.snapshot();
  EXPECT_NEAR(snapshot.latest.T_map_robot.x_m(), 2.0, 1e-12);
  EXPECT_NEAR(snapshot.latest.T_map_robot.y_m(), 3.5, 1e-12);
  stamp_us = 2000;
  read(travel(1.5, 0.0), 0.0, 1.0);
  EXPECT_NEAR(pipeline.snapshot().points->points().back().position_m.y(), 4.5, 1e-9);
}

TEST_F(RobotPipelineTest, KeepsStampsOfTheTrajectoryRising) {
  pipeline.on_odometry({at_us(2000), travel(0.2, 0.0)});
  pipeline.on_odometry({at_us(1000), travel(0.1, 0.0)});
  pipeline.on_odometry({at_us(2000), travel(0.2, 0.0)});
  EXPECT_EQ(pipeline.snapshot().trajectory->size(), 1U);
}

TEST_F(RobotPipelineTest, PlacesEachReadingByItsOwnWheels) {
  pipeline.begin_scan();
  read(travel(0.0, 0.0), 90.0, 1.0);
  read(travel(0.0, geometry::radians(180.0)), 90.0, 2.0);
  pipeline.end_scan();
  const Snapshot snapshot = pipeline.snapshot();
  const auto& points = snapshot.points->points();
  ASSERT_EQ(points.size(), 2U);
  EXPECT_NEAR((points[0].position_m - Eigen::Vector2d(0.0, 1.0)).norm(), 0.0, 1e-9);
  EXPECT_EQ(points[1].pose_index, 1U);
  EXPECT_NEAR(points[1].position_m.y(), -2.0, 1e-9);
}

TEST_F(RobotPipelineTest, PlacesTheSonarWhereItIsMounted) {
  sensors::RobotGeometry robot = plain_robot();
  robot.sonar_x_m = 0.05;
  RobotPipeline mounted(robot);
  mounted.on_sonar({at_us(1), {}, geometry::radians(90.0), 1.0});
  const Eigen::Vector2d echo_m = mounted.snapshot().points->points().front().position_m;
  EXPECT_NEAR((echo_m - Eigen::Vector2d(0.05, 1.0)).norm(), 0.0, 1e-9);
}

TEST_F(RobotPipelineTest, MakesOneScanOfSeveralSweeps) {
  scan(0.0, 1.0);
  const Snapshot snapshot = pipeline.snapshot();
  EXPECT_EQ(snapshot.stops, 1U);
  EXPECT_EQ(snapshot.last_scan->size(), 120U);
  EXPECT_EQ(snapshot.points->points().size(), 120U);
  EXPECT_GT(snapshot.newly_free_m2, 0.5);
}

TEST_F(RobotPipelineTest, SaysWhatTheLastStopHasAdded) {
  scan(0.0, 1.0);
  const double first_m2 = pipeline.snapshot().newly_free_m2;
  scan(0.0, 1.0);
  EXPECT_LT(pipeline.snapshot().newly_free_m2, first_m2);
}

TEST_F(RobotPipelineTest, KeepsReadingsOutsideOfAScanOutOfTheGrid) {
  sweep(travel(0.0, 0.0), 1.0);
  const Snapshot snapshot = pipeline.snapshot();
  EXPECT_EQ(snapshot.points->points().size(), 30U);
  EXPECT_TRUE(snapshot.grid->bounds().empty());
  EXPECT_EQ(snapshot.stops, 0U);
}

TEST_F(RobotPipelineTest, KeepsAScanOfASonarThatHangsOutOfTheGrid) {
  scan(0.0, 1.0);
  const auto before = tests::drawing_of(mapping::rasterize(*pipeline.snapshot().grid));
  pipeline.begin_scan();
  for (int pan_deg = -90; pan_deg < 90; pan_deg += 6) {
    read(travel(0.0, 0.0), pan_deg, 0.5);
  }
  pipeline.end_scan();
  const Snapshot snapshot = pipeline.snapshot();
  EXPECT_EQ(snapshot.last_scan_fault, mapping::ScanFault::kStuck);
  EXPECT_EQ(snapshot.stops, 2U);
  EXPECT_EQ(snapshot.newly_free_m2, 0.0);
  EXPECT_EQ(tests::drawing_of(mapping::rasterize(*snapshot.grid)), before);
}

TEST_F(RobotPipelineTest, KeepsAScanOfAnotherPlaceOutOfTheGridAndItsPose) {
  scan(0.0, 1.5);
  scan(0.0, 1.5);
  const auto before = tests::drawing_of(mapping::rasterize(*pipeline.snapshot().grid));
  scan(0.0, 0.6);
  EXPECT_EQ(pipeline.snapshot().last_scan_fault, mapping::ScanFault::kElsewhere);
  EXPECT_EQ(tests::drawing_of(mapping::rasterize(*pipeline.snapshot().grid)), before);
  scan(0.0, 1.5);
  EXPECT_EQ(pipeline.snapshot().last_scan_fault, mapping::ScanFault::kNone);
}

TEST_F(RobotPipelineTest, EndsAnOpenScanBeforeTheNext) {
  pipeline.begin_scan();
  read(travel(0.0, 0.0), 0.0, 1.0);
  pipeline.begin_scan();
  EXPECT_EQ(pipeline.snapshot().stops, 1U);
  EXPECT_EQ(pipeline.snapshot().last_scan->size(), 1U);
}

TEST_F(RobotPipelineTest, DoesNothingAtTheEndOfNoScan) {
  pipeline.end_scan();
  EXPECT_EQ(pipeline.snapshot().stops, 0U);
}

TEST_F(RobotPipelineTest, LeavesEarlierSnapshotsAsTheyWere) {
  scan(0.0, 1.0);
  const Snapshot before = pipeline.snapshot();
  const auto drawing = tests::drawing_of(mapping::rasterize(*before.grid));
  scan(0.6, 1.0);
  EXPECT_EQ(tests::drawing_of(mapping::rasterize(*before.grid)), drawing);
  EXPECT_EQ(before.points->points().size(), 120U);
  EXPECT_EQ(pipeline.snapshot().points->points().size(), 240U);
}

TEST_F(RobotPipelineTest, SurvivesAScanWithoutAnyEcho) {
  pipeline.begin_scan();
  for (int pan_deg = -60; pan_deg <= 60; pan_deg += 6) {
    read({}, pan_deg, std::nullopt);
  }
  pipeline.end_scan();
  const Snapshot snapshot = pipeline.snapshot();
  EXPECT_EQ(snapshot.stops, 1U);
  EXPECT_EQ(snapshot.newly_free_m2, 0.0);
  EXPECT_EQ(snapshot.points->poses().size(), 1U);
  EXPECT_TRUE(snapshot.points->points().empty());
}

/// The same with SLAM that knows where the robot was only when it has heard the second stop.
TEST_F(RobotPipelineTest, MovesAllToWhereSlamHasIt) {
  auto method = std::make_unique<MovedAside>();
  MovedAside& slam = *method;
  slam.T_map_odom = {};
  RobotPipeline placed(plain_robot(), {}, {}, std::move(method));
  std::swap(pipeline, placed);
  scan(0.0, 1.0);
  slam.T_map_odom = {0.0, 0.3, 0.0};
  scan(0.0, 1.0);

  const Snapshot snapshot = pipeline.snapshot();
  EXPECT_EQ(pipeline.slam(), &slam);
  EXPECT_NEAR(snapshot.latest.T_map_robot.y_m(), 0.3, 0.02);
  EXPECT_NEAR(snapshot.trajectory->front().T_map_robot.y_m(), 0.3, 1e-9);
  EXPECT_NEAR(snapshot.points->poses().front().y_m(), 0.3, 1e-9);
  EXPECT_NEAR(snapshot.last_scan->front().T_map_robot.y_m(), 0.3, 0.02);
  ASSERT_EQ(snapshot.scans->size(), 2U);
  EXPECT_NEAR(snapshot.scans->front().front().T_map_robot.y_m(), 0.3, 0.02);
  EXPECT_EQ(snapshot.grid->state(snapshot.grid->cell_at({0.0, 1.15})), mapping::CellState::kFree)
      << "the floor of both stops moved";
}

TEST_F(RobotPipelineTest, KeepsAScanOfAnotherPlaceFromSlam) {
  auto method = std::make_unique<MovedAside>();
  const MovedAside& slam = *method;
  RobotPipeline placed(plain_robot(), {}, {}, std::move(method));
  std::swap(pipeline, placed);
  scan(0.0, 1.5);
  scan(0.0, 1.5);
  const std::size_t beams = slam.beams;
  scan(0.0, 0.6);
  EXPECT_EQ(pipeline.snapshot().last_scan_fault, mapping::ScanFault::kElsewhere);
  EXPECT_EQ(pipeline.snapshot().scans->size(), 2U);
  EXPECT_EQ(slam.beams, beams);
}

TEST(RobotPipeline, CountsHowOftenTheRobotWasLifted) {
  RobotPipeline pipeline(sensors::RobotGeometry{});
  EXPECT_EQ(pipeline.snapshot().times_lifted, 0U);
  for (const bool lifted : {false, true, true, false, true}) {
    pipeline.on_hazards({.stamp = {}, .lifted = lifted});
  }
  EXPECT_EQ(pipeline.snapshot().times_lifted, 2U);
  EXPECT_TRUE(pipeline.snapshot().hazards.lifted);
}

TEST_F(RobotPipelineTest, IsThereOnItsMapWhereSomebodyHasCarriedIt) {
  scan(0.5, 1.5);
  pipeline.on_hazards({.stamp = at_us(++stamp_us), .lifted = true});
  pipeline.begin_scan();
  const geometry::Pose2 T_map_robot(3.0, -1.0, 1.0);
  pipeline.on_carried({at_us(++stamp_us), travel(9.0, 0.0), T_map_robot});
  EXPECT_EQ(pipeline.snapshot().stops, 2U) << "the open scan is ended";
  EXPECT_EQ(pipeline.snapshot().times_lifted, 0U);
  pipeline.on_odometry({at_us(++stamp_us), travel(9.5, 0.0)});
  const geometry::Pose2 T_there_robot =
      T_map_robot.inverse() * pipeline.snapshot().latest.T_map_robot;
  EXPECT_NEAR(T_there_robot.x_m(), 0.5, 1e-9);
  EXPECT_NEAR(T_there_robot.y_m(), 0.0, 1e-9);
}

TEST_F(RobotPipelineTest, TellsToWhichPosesItWasCarried) {
  pipeline.on_carried({at_us(stamp_us), travel(0.0, 0.0), geometry::Pose2()});
  pipeline.on_odometry({at_us(++stamp_us), travel(0.1, 0.0)});
  pipeline.on_carried({at_us(++stamp_us), travel(0.1, 0.0), geometry::Pose2(3.0, -1.0, 1.0)});
  const Snapshot snapshot = pipeline.snapshot();
  ASSERT_EQ(snapshot.carried_to, (std::vector<std::size_t>{0, 2}));
  EXPECT_EQ(snapshot.trajectory->at(1).T_map_robot.x_m(), 0.1);
  EXPECT_NEAR(snapshot.trajectory->at(2).T_map_robot.x_m(), 3.0, 1e-9);
}

TEST_F(RobotPipelineTest, CountsAPoseThatComesLaterWhereTheStampOfTheCarryIsNotNew) {
  pipeline.on_odometry({at_us(stamp_us), travel(0.0, 0.0)});
  pipeline.on_carried({at_us(stamp_us), travel(0.0, 0.0), geometry::Pose2(3.0, 0.0, 0.0)});
  pipeline.on_odometry({at_us(++stamp_us), travel(0.1, 0.0)});
  const Snapshot snapshot = pipeline.snapshot();
  ASSERT_EQ(snapshot.carried_to, (std::vector<std::size_t>{1}));
  EXPECT_NEAR(snapshot.trajectory->at(1).T_map_robot.x_m(), 3.1, 1e-9);
}

/// A body of 0.1 m with one infra-red sensor that looks ahead from its middle.
mapping::ContactMapperParams feeling_body() {
  mapping::ContactMapperParams near;
  near.body_radius_m = 0.1;
  near.T_robot_infrared = {{}};
  near.infrared_reach_m = 0.5;
  return near;
}

/// State of the cell at a place of the map.
mapping::CellState state_at(const RobotPipeline& pipeline, double x_m, double y_m) {
  const auto grid = pipeline.snapshot().grid;
  return grid->state(grid->cell_at({x_m, y_m}));
}

TEST(RobotPipeline, MapsWhatItFeelsWhereItsWheelsHaveBroughtIt) {
  using mapping::CellState;
  RobotPipeline pipeline(plain_robot(), {}, feeling_body());
  pipeline.on_odometry({at_us(1000), travel(1.01, 0.0)});
  EXPECT_EQ(state_at(pipeline, 0.27, 0.01), CellState::kUnknown);
  pipeline.on_odometry({at_us(2000), travel(1.02, 0.0)});
  pipeline.on_odometry({at_us(3000), travel(1.03, 0.0)});
  EXPECT_EQ(state_at(pipeline, 1.03, 0.01), CellState::kFree);
  pipeline.on_hazards({.stamp = at_us(3000), .bump_left = true, .bump_right = true});
  EXPECT_EQ(state_at(pipeline, 1.13, 0.01), CellState::kOccupied);
  pipeline.on_infrared({at_us(4000), travel(1.03, geometry::radians(90.0)), {0.4}});
  EXPECT_EQ(state_at(pipeline, 1.02, 0.41), CellState::kOccupied);
}

TEST(RobotPipeline, ABumpIsToldOnceHoweverLongTheSwitchIsClosed) {
  RobotPipeline pipeline(plain_robot(), {}, feeling_body());
  for (int i = 0; i < 5; ++i) {
    pipeline.on_hazards({.stamp = at_us(i), .bump_left = true, .bump_right = true});
  }
  const auto grid = pipeline.snapshot().grid;
  EXPECT_EQ(grid->centilogits(grid->cell_at({0.11, 0.01})), 295);
}

TEST_F(RobotPipelineTest, KeepsWhatItFeltWhenAScanRemakesTheGrid) {
  RobotPipeline feeling(plain_robot(), {}, feeling_body());
  feeling.on_hazards({.stamp = at_us(1), .bump_left = true, .bump_right = true});
  feeling.begin_scan();
  for (int pan_deg = -180; pan_deg < 180; pan_deg += 6) {
    const double range_m = pan_deg % 4 == 0 ? 1.006 : 1.0;
    feeling.on_sonar({at_us(50'000 + pan_deg), {}, geometry::radians(pan_deg), range_m});
  }
  feeling.end_scan();
  EXPECT_EQ(state_at(feeling, 0.11, 0.01), mapping::CellState::kOccupied);
  EXPECT_EQ(state_at(feeling, 0.0, 0.4), mapping::CellState::kFree);
}

/// All round, with an echo or not.
void scan_without_echo(RobotPipeline& pipeline, bool has_answered) {
  pipeline.begin_scan();
  for (int pan_deg = -180; pan_deg < 180; pan_deg += 6) {
    pipeline.on_sonar(
        {at_us(50'000 + pan_deg), {}, geometry::radians(pan_deg), std::nullopt, has_answered});
  }
  pipeline.end_scan();
}

TEST(RobotPipeline, MapsTheFloorOfAnOpenHallButNotWhatADeadSonarDoesNotSay) {
  for (const bool has_answered : {true, false}) {
    RobotPipeline pipeline(plain_robot());
    scan_without_echo(pipeline, has_answered);
    const auto snapshot = pipeline.snapshot();
    EXPECT_EQ(snapshot.stops, 1U);
    EXPECT_EQ(snapshot.last_scan->size(), 60U);
    EXPECT_EQ(snapshot.scans->size(), has_answered ? 1U : 0U);
    EXPECT_EQ(state_at(pipeline, 0.5, 0.3) == mapping::CellState::kFree, has_answered);
  }
}

TEST(RobotPipeline, MapsNothingMoreOfWhatItFeelsOnceItWasLifted) {
  RobotPipeline pipeline(plain_robot(), {}, feeling_body());
  pipeline.on_hazards({.stamp = at_us(1), .lifted = true});
  pipeline.on_hazards({.stamp = at_us(2), .bump_left = true});
  pipeline.on_odometry({at_us(3), travel(1.0, 0.0)});
  pipeline.on_infrared({at_us(4), travel(1.0, 0.0), {0.4}});
  EXPECT_TRUE(pipeline.snapshot().grid->bounds().empty());
}

TEST(RobotPipeline, SharesOneGridBetweenSnapshotsWhileNothingHasChanged) {
  RobotPipeline pipeline(plain_robot(), {}, feeling_body());
  pipeline.on_odometry({at_us(1), travel(0.1, 0.0)});
  const auto before = pipeline.snapshot().grid;
  EXPECT_EQ(pipeline.snapshot().grid, before);
  pipeline.on_odometry({at_us(2), travel(0.2, 0.0)});
  EXPECT_NE(pipeline.snapshot().grid, before);
}

TEST(RobotPipeline, ShowsTheLastOfEverySensor) {
  RobotPipeline pipeline(sensors::RobotGeometry{});
  EXPECT_FALSE(pipeline.snapshot().yaw);
  EXPECT_FALSE(pipeline.snapshot().battery);
  pipeline.on_infrared({.stamp = {}, .travel = {}, .range_m = {0.05, std::nullopt}});
  pipeline.on_yaw({.stamp = {}, .yaw = {0.5, 1.0, 0}});
  pipeline.on_battery({.stamp = {}, .voltage_v = 7.4});
  const Snapshot snapshot = pipeline.snapshot();
  EXPECT_EQ(snapshot.infrared.range_m.size(), 2U);
  EXPECT_EQ(snapshot.yaw->yaw.yaw_rad, 0.5);
  EXPECT_EQ(snapshot.battery->voltage_v, 7.4);
}

TEST(RobotPipeline, PlacesRangeScansWhereSlamHasThem) {
  RobotPipeline pipeline(plain_robot(), {}, {}, std::make_unique<MovedAside>());
  sensors::RangeScan scan;
  scan.max_range_m = 5.0;
  scan.beams = {{0.0, 1.0}};
  pipeline.on_odometry_pose({at_us(1), {}});
  pipeline.on_pose_fix({at_us(1), {5e6, 0.0, 0.0}});
  pipeline.on_odometry_pose({at_us(2), {2.0, 0.0, 0.0}});
  pipeline.on_range_scan(scan);
  pipeline.on_landmark({3, 2.0, 0.0});
  const Snapshot snapshot = pipeline.snapshot();
  // MovedAside has every scan a metre to the left.
  EXPECT_NEAR(snapshot.latest.T_map_robot.x_m(), 5e6 + 2.0, 1e-6);
  EXPECT_NEAR(snapshot.latest.T_map_robot.y_m(), 1.0, 1e-9);
  EXPECT_LT(snapshot.grid->centilogits(snapshot.grid->cell_at({5e6 + 2.5, 1.01})), 0);
  ASSERT_EQ(snapshot.landmarks->size(), 1U);
  EXPECT_NEAR(snapshot.landmarks->front().position_m.x(), 5e6 + 4.0, 1e-6);
  EXPECT_NEAR(pipeline.factor_graph().T_map_nodes.front().x_m(), 5e6 + 2.0, 1e-6);
}

TEST(RobotPipeline, TakesARobotThatTellsNoPoseToStandAtTheOrigin) {
  RobotPipeline pipeline(plain_robot(), {}, {}, std::make_unique<MovedAside>());
  pipeline.on_landmark({3, 2.0, 0.0});
  EXPECT_EQ(pipeline.snapshot().landmarks->size(), 1U);
  EXPECT_THROW(RobotPipeline(plain_robot()).factor_graph(), std::logic_error);
}

}  // namespace
}  // namespace echomap::pipeline
