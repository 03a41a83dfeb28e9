// SPDX-License-Identifier: MIT
#include "host/evaluation/trajectory_error.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"
#include "tests/support/told_snapshot.hpp"

namespace echomap::evaluation {
namespace {

using geometry::Pose2;
using pipeline::StampedPose;
using tests::pose_at;

TruePose true_at(double stamp_s, const Pose2& T_world_robot) {
  return {pose_at(stamp_s, {}).stamp, T_world_robot};
}

/// A circle, a pose every `period_s`, seen from a frame.
std::vector<StampedPose> circle(double period_s, double end_s, const Pose2& T_frame_start = {}) {
  std::vector<StampedPose> trajectory;
  for (int i = 0; i * period_s <= end_s + 1e-9; ++i) {
    const double turn_rad = 0.3 * i * period_s;
    const Pose2 T_start_robot(std::sin(turn_rad), 1.0 - std::cos(turn_rad), turn_rad);
    trajectory.push_back(pose_at(i * period_s, T_frame_start * T_start_robot));
  }
  return trajectory;
}

/// The same circle as the truth of a robot that drove it.
std::vector<TruePose> true_circle(double period_s, double end_s, const Pose2& T_world_start = {}) {
  std::vector<TruePose> truth;
  for (const auto& [stamp, T_world_robot] : circle(period_s, end_s, T_world_start)) {
    truth.push_back({stamp, T_world_robot});
  }
  return truth;
}

TEST(TrajectoryError, IsNothingForTheSameWayInAnotherFrame) {
  const auto error = score_trajectory(circle(0.1, 10.0), true_circle(0.1, 10.0, {2.0, -1.0, 2.5}));
  EXPECT_NEAR(error.ate_rmse_m, 0.0, 1e-9);
  EXPECT_NEAR(error.ate_heading_rmse_rad, 0.0, 1e-9);
  EXPECT_NEAR(error.final_error_m, 0.0, 1e-9);
}

TEST(TrajectoryError, InterpolatesTheTruthInTime) {
  const auto error = score_trajectory(circle(0.07, 10.0), true_circle(0.02, 10.0));
  EXPECT_LT(error.ate_rmse_m, 1e-4);
  EXPECT_LT(error.ate_heading_rmse_rad, 1e-6);
}

TEST(TrajectoryError, InterpolatesHeadingsAcrossTheBack) {
  const std::vector<TruePose> truth{true_at(0.0, {0.0, 0.0, geometry::radians(170.0)}),
                                    true_at(2.0, {0.0, 0.0, geometry::radians(-170.0)})};
  const std::vector<StampedPose> estimate{pose_at(0.0, {0.0, 0.0, 0.0}),
                                          pose_at(1.0, {0.0, 0.0, geometry::radians(10.0)})};
  EXPECT_NEAR(score_trajectory(estimate, truth).ate_heading_rmse_rad, 0.0, 1e-9);
}

TEST(TruePoseAt, IsEmptyOutsideOfTheTruth) {
  const auto truth = true_circle(1.0, 2.0);
  EXPECT_EQ(true_pose_at(truth, true_at(1.0, {}).stamp)->x_m(), truth[1].T_world_robot.x_m());
  EXPECT_FALSE(true_pose_at(truth, true_at(-0.1, {}).stamp));
  EXPECT_FALSE(true_pose_at(truth, true_at(2.1, {}).stamp));
}

TEST(TrajectoryError, FitsNothing) {
  // Heading off by 90 degrees from the second pose on: a fit would share it out, this must not.
  const std::vector<TruePose> truth{
      true_at(0.0, {}), true_at(1.0, {1.0, 0.0, 0.0}), true_at(2.0, {2.0, 0.0, 0.0})};
  const std::vector<StampedPose> estimate{pose_at(0.0, {}),
                                          pose_at(1.0, {1.0, 0.0, std::numbers::pi / 2.0}),
                                          pose_at(2.0, {1.0, 1.0, std::numbers::pi / 2.0})};
  const auto error = score_trajectory(estimate, truth);
  EXPECT_NEAR(error.final_error_m, std::sqrt(2.0), 1e-9);
  EXPECT_NEAR(error.ate_rmse_m, std::sqrt(2.0 / 3.0), 1e-9);
  EXPECT_NEAR(error.final_heading_error_rad, std::numbers::pi / 2.0, 1e-9);
}

TEST(TrajectoryError, LooksOnlyWhereThereIsTruth) {
  auto estimate = circle(0.1, 10.0);
  estimate.push_back(pose_at(99.0, {50.0, 50.0, 0.0}));
  EXPECT_NEAR(score_trajectory(estimate, true_circle(0.1, 10.0)).final_error_m, 0.0, 1e-9);
}

TEST(TrajectoryError, NeedsACommonInstant) {
  EXPECT_THROW(score_trajectory({}, true_circle(0.1, 1.0)), std::invalid_argument);
  EXPECT_THROW(score_trajectory(circle(0.1, 1.0), {}), std::invalid_argument);
  EXPECT_THROW(score_trajectory({pose_at(5.0, {})}, true_circle(0.1, 1.0)), std::invalid_argument);
}

TEST(TrajectoryError, FitsByTheWholeWayAndNotByItsStart) {
  auto estimate = circle(0.1, 10.0);
  const Pose2 T_world_map(2.0, -1.0, 2.5);
  const auto truth = true_circle(0.1, 10.0, T_world_map);
  estimate.front() = pose_at(0.0, {0.0, 0.0, 0.2});
  const Pose2 fitted = fit_aligned(estimate, truth);
  EXPECT_NEAR(fitted.heading_rad(), 2.5, 1e-9);
  EXPECT_NEAR((fitted.position_m() - T_world_map.position_m()).norm(), 0.0, 1e-9);
  EXPECT_NEAR(start_aligned(estimate, truth).heading_rad(), 2.3, 1e-9);
}

TEST(TrajectoryError, FitsARobotThatHasNotMovedByItsStart) {
  const std::vector<TruePose> truth{true_at(0.0, {2.0, 1.0, 0.5}), true_at(9.0, {2.0, 1.0, 0.5})};
  const Pose2 fitted = fit_aligned({pose_at(0.0, {}), pose_at(1.0, {0.001, 0.0, 0.0})}, truth);
  EXPECT_NEAR(fitted.heading_rad(), 0.5, 1e-12);
  EXPECT_THROW(fit_aligned({pose_at(99.0, {})}, truth), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::evaluation
