// SPDX-License-Identifier: MIT
#include "host/localization/peer_sighting.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"

namespace echomap::localization {
namespace {

using geometry::radians;

/// Looks to the north and sees the other one 2 m to its left, in the west.
const PoseGaussian observer{{1.0, 1.0, radians(90.0)},
                            Eigen::Vector3d(0.01, 0.04, 0.0025).asDiagonal()};
const PoseGaussian peer{{-1.1, 1.1, 0.3}, Eigen::Vector3d(0.09, 0.01, 0.5).asDiagonal()};
const PeerSighting sighting{5.0, 2.0, radians(90.0), 0.1, 0.05};

TEST(PeerSighting, IsALandmarkAsUnsureAsTheOtherRobot) {
  const LandmarkObservation seen = peer_as_landmark(sighting, observer, peer);
  EXPECT_EQ(seen.stamp_s, 5.0);
  EXPECT_TRUE(seen.landmark_m.isApprox(Eigen::Vector2d(-1.1, 1.1)));
  EXPECT_NEAR(seen.range_stddev_m, std::sqrt(0.01 + 2.0 * 0.09), 1e-12);
  EXPECT_NEAR(seen.bearing_stddev_rad, std::sqrt(0.0025 + 2.0 * 0.01 / 4.0), 1e-12);
}

TEST(PeerSighting, IsAFixAsUnsureAsTheOneThatLooks) {
  const PoseFix fix = peer_as_fix(sighting, observer, peer);
  EXPECT_NEAR(fix.T_map_robot.x_m(), -1.0, 1e-12);
  EXPECT_NEAR(fix.T_map_robot.y_m(), 1.0, 1e-12);
  EXPECT_EQ(fix.T_map_robot.heading_rad(), 0.3);
  EXPECT_NEAR(fix.covariance(0, 0), 2.0 * 0.01 + 0.01, 1e-12);
  // Its place and, two metres away, its heading; and the bearing.
  EXPECT_NEAR(fix.covariance(1, 1), 2.0 * (0.04 + 4.0 * 0.0025) + 4.0 * 0.0025, 1e-12);
  EXPECT_TRUE(is_covariance(fix.covariance));
}

TEST(PeerSighting, AFixOfItSaysNothingOfTheHeading) {
  const auto linear = linearized(peer_as_fix(sighting, observer, peer), peer.T_map_robot);
  const PoseGaussian after = corrected(peer, *linear);
  EXPECT_NEAR(after.T_map_robot.heading_rad(), 0.3, 1e-12);
  EXPECT_NEAR(after.covariance(2, 2), 0.5, 0.01);
  EXPECT_LT(after.covariance(0, 0), 0.5 * peer.covariance(0, 0));
}

}  // namespace
}  // namespace echomap::localization
