// SPDX-License-Identifier: MIT
#include "host/evaluation/belief_error.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace echomap::evaluation {
namespace {

using geometry::Pose2;
using time::robot_time;

const std::vector<TruePose> true_poses{{robot_time(1.0), {0.0, 0.0, 0.0}},
                                       {robot_time(1.2), {2.0, 0.0, 0.0}},
                                       {robot_time(3.0), {2.0, 0.0, 0.0}}};

pipeline::StampedBelief belief(double stamp_s, const Pose2& T_map_robot, double stddev) {
  return {robot_time(stamp_s), {T_map_robot, stddev * stddev * Eigen::Matrix3d::Identity()}};
}

TEST(BeliefError, ComparesWithTheTruthInBetween) {
  const auto error = score_beliefs(
      {belief(1.0, {0.3, 0.4, 0.0}, 1.0), belief(1.1, {1.0, 0.0, 0.2}, 1.0)}, true_poses);
  EXPECT_EQ(error.poses, 2U);
  EXPECT_NEAR(error.rmse_m, 0.5 / std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(error.heading_rmse_rad, 0.2 / std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(error.expected_rmse_m, std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(error.nees, 0.5 * (0.25 + 0.04), 1e-12);
  EXPECT_EQ(error.within_95, 1.0);
}

TEST(BeliefError, ABeliefThatIsTooSureIsOutsideOfItsEllipse) {
  const auto error = score_beliefs(
      {belief(1.0, {0.3, 0.0, 0.0}, 0.1), belief(1.0, {0.2, 0.0, 0.0}, 0.1)}, true_poses);
  EXPECT_EQ(error.within_95, 0.5);
  EXPECT_NEAR(error.nees, 0.5 * (9.0 + 4.0), 1e-9);
}

TEST(BeliefError, LeavesOutWhatTheTruthDoesNotCover) {
  const auto error = score_beliefs({belief(0.5, {}, 1.0), belief(2.0, {}, 1.0)}, true_poses);
  EXPECT_EQ(error.poses, 0U);
  EXPECT_EQ(error.rmse_m, 0.0);
}

}  // namespace
}  // namespace echomap::evaluation
