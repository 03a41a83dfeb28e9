// SPDX-License-Identifier: MIT
#include "host/diagnosis/placed_log.hpp"

#include <numbers>

#include <gtest/gtest.h>

#include "tests/host/diagnosis/box_log.hpp"

namespace echomap::diagnosis {
namespace {

/// A wall ahead of the start at 1.9 m, which the robot hears again from 0.4 m nearer.
TEST(PlacedLog, HasTheSameWallFromEveryPlaceForTheErrorsThatTheRobotHas) {
  RobotErrors truth;
  truth.left_scale = truth.right_scale = 0.8;
  truth.range_scale = 1.1;
  truth.pan_offset_rad = 0.1;
  BoxLog box(truth);
  box.ping(-0.1).drive(0.25).drive(0.25).ping(-0.1).drive(0.1);
  const PlacedLog placed = place(box.log(), truth);
  ASSERT_EQ(placed.pings.size(), 2U);
  EXPECT_NEAR(placed.pings[0].at_m.x(), 0.0, 1e-12);
  EXPECT_NEAR(placed.pings[1].at_m.x(), 0.4, 1e-12);
  EXPECT_NEAR(placed.pings[1].direction.y(), 0.0, 1e-12);
  EXPECT_NEAR(placed.pings[0].at_m.x() + placed.pings[0].range_m, 1.9, 1e-12);
  EXPECT_NEAR(placed.pings[1].at_m.x() + placed.pings[1].range_m, 1.9, 1e-12);
  EXPECT_NEAR(placed.pings[1].travelled_m, 0.5, 1e-12) << "by the profile";
}

TEST(PlacedLog, PlacesSurfacesFromWhereTheRobotStood) {
  BoxLog box({});
  box.stand().turn(0.5 * std::numbers::pi).drive(0.3).stand();
  const PlacedLog placed = place(box.log(), {});
  ASSERT_EQ(placed.stands.size(), 2U);
  const auto has = [&](std::size_t stand, double x_m, double y_m) {
    for (const PlacedSurface& surface : placed.stands[stand].surfaces) {
      if ((surface.foot_m - Eigen::Vector2d(x_m, y_m)).norm() < 0.05) {
        return surface.is_wall;
      }
    }
    return false;
  };
  EXPECT_TRUE(has(0, 1.9, 0.0));
  EXPECT_TRUE(has(1, 0.0, 1.3));
  EXPECT_FALSE(has(1, 0.0, 1.0));
}

TEST(PlacedLog, MirrorsWhatAReversedPanHears) {
  RobotErrors reversed;
  reversed.pan_scale = -1.0;
  BoxLog box({});
  box.stand().ping(0.5 * std::numbers::pi).drive(0.1);
  const PlacedLog placed = place(box.log(), reversed);
  ASSERT_EQ(placed.pings.size(), 1U);
  EXPECT_NEAR(placed.pings.front().direction.y(), -1.0, 1e-12);
}

}  // namespace
}  // namespace echomap::diagnosis
