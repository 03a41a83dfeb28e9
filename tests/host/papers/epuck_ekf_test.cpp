// SPDX-License-Identifier: MIT
// Mahmood and Ridao 2017, section 4.1, EKF localization: an e-puck under a camera in its field. The
// filter starts in the middle, unsure of all of the field. The paper names no noise; ours is that
// of a camera of millimetre pixels that tells late and now and then not at all.
#include "host/papers/epuck_ekf.hpp"

#include <gtest/gtest.h>

namespace echomap::papers {
namespace {

OverheadCamera camera_until(int step) {
  OverheadCamera camera = late_camera();
  camera.until_step = step;
  return camera;
}

TEST(Paper002Ekf, ErrorsStayWithinThreeSigma) {
  double beyond = 0.0;
  for (std::uint32_t seed = 1; seed <= 40; ++seed) {
    const EkfDrive drive = follow_epuck(late_camera(), seed);
    EXPECT_LE(drive.gated, 2U) << seed;
    EXPECT_LT(error_of(drive.steps.back()).head<2>().norm(), 0.01) << seed;
    beyond += share_beyond_three_sigma(drive) / 40.0;
  }
  // 0.27 % of a normal distribution.
  EXPECT_LT(beyond, 0.006);
}

TEST(Paper002Ekf, BeliefNarrowsFromAllOfTheFieldToAFewMillimetres) {
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    const EkfDrive drive = follow_epuck(late_camera(), seed);
    EXPECT_GT(planar_stddev_m(drive.steps.front()), 0.002) << seed;
    EXPECT_LT(planar_stddev_m(drive.steps[76]), 0.005) << seed;
    EXPECT_LT(error_of(drive.steps[76]).head<2>().norm(), 0.01) << seed;
  }
}

TEST(Paper002Ekf, WithoutTheCameraItFollowsOnAndGrowsUnsure) {
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    const EkfDrive drive = follow_epuck(camera_until(80), seed);
    const EkfStep& last = drive.steps.back();
    EXPECT_GT(planar_stddev_m(last), 2.0 * planar_stddev_m(drive.steps[80])) << seed;
    EXPECT_LT(error_of(last).head<2>().norm(), 4.0 * planar_stddev_m(last)) << seed;
  }
}

TEST(Paper002Ekf, TheCameraAsToldReportsInEachIterationAndAtOnce) {
  const EkfDrive drive = follow_epuck({}, 1);
  for (const EkfStep& step : drive.steps) {
    ASSERT_TRUE(step.fix_m);
    EXPECT_LT((*step.fix_m - step.T_world_robot.position_m()).norm(), 0.01);
    EXPECT_LT(planar_stddev_m(step), 0.003);
  }
  EXPECT_GT(anywhere_in_the_field().covariance(0, 0), 0.1);
}

TEST(Paper002Ekf, AfterTheCameraHasStoppedThereAreNoFixes) {
  const EkfDrive drive = follow_epuck({.until_step = 80}, 1);
  EXPECT_TRUE(drive.steps[79].fix_m);
  EXPECT_FALSE(drive.steps[80].fix_m);
}

}  // namespace
}  // namespace echomap::papers
