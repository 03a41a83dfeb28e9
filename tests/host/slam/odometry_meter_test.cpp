// SPDX-License-Identifier: MIT
#include "host/slam/odometry_meter.hpp"

#include <gtest/gtest.h>

namespace echomap::slam {
namespace {

TEST(OdometryMeter, AddsUpPathAndTurns) {
  OdometryMeter meter;
  meter.follow({5.0, 5.0, 1.0});
  const OdometryMark begin = meter.mark();
  meter.follow({5.0, 5.0, 1.5});
  meter.follow({5.0, 5.0, 1.2});
  meter.follow(geometry::Pose2(5.0, 5.0, 1.2) * geometry::Pose2(0.4, 0.0, 0.0));
  const OdometryPiece piece = piece_between(begin, meter.mark());
  EXPECT_NEAR(piece.path_m, 0.4, 1e-12);
  EXPECT_NEAR(piece.turn_rad, 0.2, 1e-12);
  EXPECT_NEAR(piece.turned_rad, 0.8, 1e-12);
  EXPECT_NEAR(piece.T_before_after.heading_rad(), 0.2, 1e-12);
  EXPECT_EQ(piece.jumped_m, 0.0);
}

TEST(OdometryMeter, CountsATurnPastHalfARoundInFull) {
  OdometryMeter meter;
  const OdometryMark begin = meter.mark();
  for (int i = 0; i <= 8; ++i) {
    meter.follow({0.0, 0.0, 0.5 * i});
  }
  EXPECT_NEAR(piece_between(begin, meter.mark()).turn_rad, 4.0, 1e-9);
}

TEST(OdometryMeter, TakesACarryAndALongStepForJumps) {
  OdometryMeter meter;
  meter.follow({});
  meter.carry({0.2, 0.0, 0.1});
  meter.follow({3.2, 0.0, 0.1});
  EXPECT_NEAR(meter.mark().jumped_m, 3.2, 1e-12);
  EXPECT_NEAR(meter.mark().jumped_rad, 0.1, 1e-12);
  EXPECT_EQ(meter.mark().path_m, 0.0);
}

}  // namespace
}  // namespace echomap::slam
