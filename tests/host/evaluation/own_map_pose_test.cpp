// SPDX-License-Identifier: MIT
#include "host/evaluation/own_map_pose.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/support/told_snapshot.hpp"

namespace echomap::evaluation {
namespace {

using geometry::Pose2;
using pipeline::StampedPose;
using tests::pose_at;

/// A corridor of the world that the robot drove from (2, 1) to (8, 1) in six seconds, and its map:
/// straight for three metres, then bent to the left by a tenth of a radian.
class BentCorridor : public ::testing::Test {
 protected:
  BentCorridor() {
    for (int i = 0; i <= 6; ++i) {
      const Pose2 T_world_robot(2.0 + i, 1.0, 0.0);
      truth.push_back({pose_at(i, {}).stamp, T_world_robot});
      explored.push_back(pose_at(i, map_at(T_world_robot)));
    }
  }

  /// T_map_pose by the piece of the map that the pose is in.
  static Pose2 map_at(const Pose2& T_world_pose) {
    const Pose2 T_world_start(2.0, 1.0, 0.0);
    const Pose2 T_start_pose = T_world_start.inverse() * T_world_pose;
    const Pose2 T_start_bend(2.5, 0.0, 0.0);
    const Pose2 T_map_bend(2.5, 0.0, 0.1);
    return T_start_pose.x_m() <= 2.5 ? T_start_pose
                                     : T_map_bend * T_start_bend.inverse() * T_start_pose;
  }

  std::vector<StampedPose> explored;
  std::vector<TruePose> truth;
};

void expect_same(const Pose2& one, const Pose2& other) {
  EXPECT_NEAR((one.position_m() - other.position_m()).norm(), 0.0, 1e-9);
  EXPECT_NEAR(one.heading_rad(), other.heading_rad(), 1e-9);
}

TEST_F(BentCorridor, HasAPoseWhereThePieceOfMapAroundItIs) {
  for (const Pose2& T_world_pose : {Pose2(3.1, 1.4, 2.0), Pose2(7.2, 0.6, -1.0)}) {
    expect_same(own_map_pose(explored, truth, T_world_pose), map_at(T_world_pose));
  }
}

TEST_F(BentCorridor, IsPlacedByItsStartForWhatTheRobotHasNeverBeenNear) {
  expect_same(own_map_pose(explored, truth, {8.0, 2.4, 0.0}), map_at({8.0, 2.4, 0.0}));
  expect_same(own_map_pose(explored, truth, {8.0, 2.6, 0.0}), {6.0, 1.6, 0.0});
}

TEST_F(BentCorridor, TakesOnlyInstantsThatTheTruthCovers) {
  truth.resize(3);
  expect_same(own_map_pose(explored, truth, {5.2, 1.0, 0.0}), {3.2, 0.0, 0.0});
  EXPECT_THROW(own_map_pose(explored, {}, {}), std::invalid_argument);
}

TEST_F(BentCorridor, MeasuresErrorsInItself) {
  const Pose2 T_world_robot(6.9, 1.2, 3.0);
  truth.push_back({pose_at(20.0, {}).stamp, T_world_robot});
  const Pose2 T_true_told(0.03, -0.04, -0.2);
  const auto error =
      own_map_error(explored, truth, pose_at(20.0, map_at(T_world_robot) * T_true_told));
  ASSERT_TRUE(error);
  EXPECT_NEAR(error->error_m, 0.05, 1e-9);
  EXPECT_NEAR(error->heading_error_rad, 0.2, 1e-9);
  EXPECT_TRUE(error->is_right());
  EXPECT_FALSE(own_map_error(explored, truth, pose_at(30.0, {})));
}

TEST(PlaceError, IsRightWithin30CmAnd20Degrees) {
  EXPECT_TRUE((PlaceError{0.29, geometry::radians(19.0)}.is_right()));
  EXPECT_FALSE((PlaceError{0.31, 0.0}.is_right()));
  EXPECT_FALSE((PlaceError{0.0, geometry::radians(21.0)}.is_right()));
}

}  // namespace
}  // namespace echomap::evaluation
