// SPDX-License-Identifier: MIT
#include "tests/benchmarks/mrclam6_joint.hpp"

#include <gtest/gtest.h>

#include "tests/support/real_data.hpp"

namespace echomap::bench {
namespace {

TEST(RealMrclam, EachOfFiveRobotsIsLocalizedBetterJointlyThanAlone) {
  const auto folder = tests::real_data("utias_mrclam/MRCLAM_Dataset6");
  ECHOMAP_SKIP_WITHOUT(folder);
  const auto score = localize_mrclam(folder);
  ASSERT_EQ(score.robots.size(), 5U);
  for (const auto& robot : score.robots) {
    EXPECT_LT(robot.joint.rmse_m, 0.8 * robot.alone.rmse_m) << "robot " << robot.robot;
    EXPECT_LT(robot.joint.rmse_m, 0.2 * robot.odometry.rmse_m) << "robot " << robot.robot;
    EXPECT_LT(robot.joint.nees, robot.alone.nees + 1.0) << "robot " << robot.robot;
    EXPECT_GT(robot.joint.poses, 45000U);
  }
  EXPECT_LT(score.joint_rmse_m, 0.10);
  EXPECT_GT(score.gain_percent, 35.0);
}

TEST(RealMrclam, RobotsWithoutLandmarksAreLocalizedByThoseThatSeeThem) {
  const auto folder = tests::real_data("utias_mrclam/MRCLAM_Dataset6");
  ECHOMAP_SKIP_WITHOUT(folder);
  const auto score = localize_mrclam(folder, {3, 4, 5});
  ASSERT_EQ(score.robots.size(), 5U);
  for (const auto& robot : score.robots) {
    if (robot.robot >= 3) {
      EXPECT_LT(robot.joint.rmse_m, 0.4 * robot.alone.rmse_m) << "robot " << robot.robot;
    }
  }
}

}  // namespace
}  // namespace echomap::bench
