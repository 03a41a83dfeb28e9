// SPDX-License-Identifier: MIT
#include "host/sensors/robot_geometry.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

namespace echomap::sensors {
namespace {

using std::numbers::pi;

/// The TriBot of Singh and Bedi 2013: 5.5 cm wheels, one count per degree.
constexpr RobotGeometry kTribot{.wheel_diameter_m = 0.055,
                                .track_m = 0.11,
                                .counts_per_turn = 360.0,
                                .sonar_x_m = 0.05,
                                .sonar_y_m = 0.01,
                                .sonar_forward_m = 0.02};

TEST(RobotGeometry, RollsItsCircumferenceInOneTurnOfTheWheel) {
  EXPECT_NEAR(kTribot.metres_per_tick() * 360.0, 0.055 * pi, 1e-12);
  EXPECT_EQ(kTribot.ticks_from_metres(0.055 * pi), 360);
  EXPECT_EQ(kTribot.straight(-0.055 * pi), (WheelTicks{-360, -360}));
}

TEST(RobotGeometry, RoundsToTheNearestTickEitherWay) {
  const double tick_m = kTribot.metres_per_tick();
  for (int ticks = -1000; ticks <= 1000; ++ticks) {
    ASSERT_EQ(kTribot.ticks_from_metres((ticks + 0.49) * tick_m), ticks);
    ASSERT_EQ(kTribot.ticks_from_metres((ticks - 0.49) * tick_m), ticks);
  }
}

TEST(RobotGeometry, SharesTheSpeedsOfAnArcOutByTheTrack) {
  EXPECT_EQ(kTribot.arc_speeds(0.055 * pi, 0.0), kTribot.straight(0.055 * pi));
  EXPECT_EQ(kTribot.arc_speeds(0.0, 2.0 * pi), kTribot.turn_on_spot(2.0 * pi));
  const auto arc = kTribot.arc_speeds(0.055 * pi, 1.0);
  EXPECT_EQ(arc.left + arc.right, 720);
  EXPECT_GT(arc.right, arc.left);
}

TEST(RobotGeometry, TurnsOnTheSpotAlongTheCircleOfItsTrack) {
  // Track of two wheel diameters: one turn of the body is two turns of each wheel.
  EXPECT_EQ(kTribot.turn_on_spot(2.0 * pi), (WheelTicks{-720, 720}));
  EXPECT_EQ(kTribot.turn_on_spot(-pi / 2.0), (WheelTicks{180, -180}));
}

TEST(RobotGeometry, TurnsALargerWheelLessForTheSameWay) {
  RobotGeometry uneven = kTribot;
  uneven.left_wheel_scale = 1.25;
  uneven.right_wheel_scale = 0.5;
  EXPECT_EQ(uneven.straight(0.055 * pi), (WheelTicks{288, 720}));
  EXPECT_EQ(uneven.turn_on_spot(2.0 * pi), (WheelTicks{-576, 1440}));
  EXPECT_EQ(uneven.arc_speeds(0.055 * pi, 0.0), (WheelTicks{288, 720}));
  // 360 -+ 360 / pi counts a second of wheels of scale 1.
  EXPECT_EQ(uneven.arc_speeds(0.055 * pi, 1.0), (WheelTicks{196, 949}));
}

TEST(RobotGeometry, PutsTheSonarOnAnArmThatPansAboutItsAxis) {
  const auto ahead = kTribot.T_robot_sonar(0.0);
  EXPECT_NEAR(ahead.x_m(), 0.07, 1e-12);
  EXPECT_NEAR(ahead.y_m(), 0.01, 1e-12);
  const auto left = kTribot.T_robot_sonar(pi / 2.0);
  EXPECT_NEAR(left.x_m(), 0.05, 1e-12);
  EXPECT_NEAR(left.y_m(), 0.03, 1e-12);
  EXPECT_NEAR((left * Eigen::Vector2d(1.0, 0.0)).y(), 1.03, 1e-12);
}

TEST(RobotGeometry, RefusesABodyThatCannotBe) {
  EXPECT_NO_THROW(kTribot.validate());
  EXPECT_NO_THROW(RobotGeometry{}.validate());
  for (double RobotGeometry::*field : {&RobotGeometry::wheel_diameter_m,
                                       &RobotGeometry::track_m,
                                       &RobotGeometry::counts_per_turn,
                                       &RobotGeometry::left_wheel_scale,
                                       &RobotGeometry::right_wheel_scale}) {
    for (const double wrong : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
      RobotGeometry geometry;
      geometry.*field = wrong;
      EXPECT_THROW(geometry.validate(), std::invalid_argument);
    }
  }
}

}  // namespace
}  // namespace echomap::sensors
