// SPDX-License-Identifier: MIT
#include "host/slam/ekf_slam.hpp"

#include <gtest/gtest.h>

#include "host/sensors/range_scan.hpp"
#include "host/slam/landmark_slam.hpp"
#include "host/slam/sonar_landmark_slam.hpp"

namespace echomap::slam {
namespace {

using geometry::Pose2;

sensors::RangeScan scan_of_width(double beam_width_rad) {
  return {{}, {}, {{0.0, 1.0}}, beam_width_rad, 4.0};
}

/// How sure of itself a way of SLAM is that has driven two steps; the odometry's noise of the two
/// kinds differs.
template <class Method>
double variance_of(double beam_width_rad) {
  Method method;
  method.follow(Pose2(1.0, 0.0, 0.0));
  method.add(Pose2(1.0, 0.0, 0.0), scan_of_width(beam_width_rad));
  method.add(Pose2(1.4, 0.0, 0.1), scan_of_width(beam_width_rad));
  return method.belief().covariance.trace();
}

TEST(EkfSlam, TakesThinBeamsForALaserAndConesForSonars) {
  EXPECT_EQ(variance_of<EkfSlam>(0.0), variance_of<LandmarkSlam>(0.0));
  EXPECT_EQ(variance_of<EkfSlam>(0.4), variance_of<SonarLandmarkSlam>(0.4));
  EXPECT_NE(variance_of<EkfSlam>(0.4), variance_of<EkfSlam>(0.0));
}

TEST(EkfSlam, BeginsWhereItWasFirstTold) {
  EkfSlam slam;
  slam.follow({1.0, 2.0, 0.5});
  EXPECT_TRUE(slam.trajectory().empty());
  slam.add({1.1, 2.0, 0.5}, scan_of_width(0.4));
  ASSERT_EQ(slam.trajectory().size(), 1U);
  EXPECT_NEAR(slam.trajectory().front().x_m(), 1.1, 1e-9);
  EXPECT_NEAR(slam.belief().T_map_robot.y_m(), 2.0, 1e-9);
}

}  // namespace
}  // namespace echomap::slam
