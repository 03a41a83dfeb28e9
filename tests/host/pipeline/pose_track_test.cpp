// SPDX-License-Identifier: MIT
#include "host/pipeline/pose_track.hpp"

#include <memory>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"
#include "tests/host/pipeline/moved_aside.hpp"
#include "tests/support/robot_times.hpp"

namespace echomap::pipeline {
namespace {

using tests::at_us;

Snapshot described(const PoseTrack& track) {
  Snapshot snapshot;
  track.describe(snapshot);
  return snapshot;
}

TEST(PoseTrack, AppendsAPoseOnlyWhereTheStampRises) {
  PoseTrack track(0.2, nullptr, 0.0);
  track.follow(at_us(20), {1.0, 1.0});
  EXPECT_EQ(track.follow(at_us(10), {0.5, 0.5}).x_m(), 0.5);
  track.follow(at_us(20), {0.75, 0.75});
  EXPECT_EQ(described(track).trajectory->size(), 1U);
  EXPECT_EQ(described(track).latest.T_map_robot.x_m(), 1.0);
  EXPECT_EQ(described(track).T_odom_robot.x_m(), 0.75);
}

TEST(PoseTrack, ACamerasCorrectionHoldsForAllThatComesBehindIt) {
  PoseTrack track(0.2, nullptr, 0.0);
  track.follow(at_us(1), {1.0, 1.0});
  track.fix({3.0, 1.0, geometry::radians(90.0)});
  EXPECT_EQ(described(track).latest.T_map_robot.x_m(), 3.0);
  track.follow(at_us(2), {1.5, 1.5});
  EXPECT_NEAR(track.T_map_robot().x_m(), 3.0, 1e-12);
  EXPECT_NEAR(track.T_map_robot().y_m(), 1.5, 1e-12);
}

TEST(PoseTrack, MarksWhereTheRobotWasCarriedTo) {
  PoseTrack track(0.2, nullptr, 0.0);
  track.follow(at_us(1), {1.0, 1.0});
  track.carry({at_us(2), {1.0, 1.0}, {5.0, 6.0, 0.0}});
  track.follow(at_us(3), {1.25, 1.25});
  const Snapshot snapshot = described(track);
  EXPECT_EQ(snapshot.carried_to, std::vector<std::size_t>{1});
  EXPECT_EQ((*snapshot.trajectory)[1].T_map_robot.x_m(), 5.0);
  EXPECT_EQ(snapshot.latest.T_map_robot.x_m(), 5.25);
}

TEST(PoseTrack, ASnapshotKeepsTheTrajectoryThatItHas) {
  PoseTrack track(0.2, nullptr, 0.0);
  track.follow(at_us(1), sensors::WheelTravel());
  const Snapshot before = described(track);
  track.follow(at_us(2), sensors::WheelTravel());
  EXPECT_EQ(before.trajectory->size(), 1U);
  EXPECT_EQ(described(track).trajectory->size(), 2U);
}

TEST(PoseTrack, KnowsItsPositionAsWellAsSlamDoes) {
  EXPECT_EQ(described(PoseTrack(0.2, nullptr, 0.0)).position_stddev_m, std::nullopt);
  auto slam = std::make_unique<MovedAside>();
  slam->covariance = Eigen::Vector3d(0.01, 0.09, 4.0).asDiagonal();
  PoseTrack track(0.2, std::move(slam), 0.1);
  EXPECT_EQ(described(track).position_stddev_m, 0.0) << "before the first scan";
  track.slam()->begin_stop();
  track.slam()->add_ping(track.follow(at_us(1), {1.0, 1.0}), {}, 1.0);
  track.slam()->end_stop(true);
  EXPECT_NEAR(described(track).position_stddev_m.value_or(0.0), 0.3, 1e-12);
}

TEST(PoseTrack, SlamMovesItsWholeTrajectory) {
  PoseTrack track(0.2, std::make_unique<MovedAside>(), 0.1);
  ASSERT_NE(track.slam(), nullptr);
  track.slam()->begin_stop();
  const geometry::Pose2 T_odom_robot = track.follow(at_us(1), {1.0, 1.0});
  track.slam()->add_ping(T_odom_robot, {}, 1.0);
  track.slam()->end_stop(true);
  EXPECT_EQ(described(track).latest.T_map_robot.y_m(), 0.0);
  EXPECT_EQ(track.apply_corrected_trajectory().size(), 1U);
  EXPECT_EQ(described(track).latest.T_map_robot.y_m(), 1.0);
  EXPECT_EQ(track.T_map_robot().y_m(), 1.0);
}

}  // namespace
}  // namespace echomap::pipeline
