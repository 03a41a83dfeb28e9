// SPDX-License-Identifier: MIT
#include "host/slam/turn_calibration.hpp"

#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"
#include "tests/support/smooth_room.hpp"

namespace echomap::slam {
namespace {

using geometry::Pose2;
using geometry::radians;

constexpr double kFullTurn = 2.0 * std::numbers::pi;

/// Half a turn ahead, read in steps of a degree to either side of a body that odometry believes to
/// be turned by `turn_rad`, and that is turned by (1 + share) of it.
void sweep(const tests::SmoothRoom& room,
           double turn_rad,
           double share,
           std::mt19937& random,
           std::vector<StopReading>& readings) {
  std::normal_distribution<double> noise_m(0.0, 0.03);
  for (int degree = -90; degree < 90; ++degree) {
    StopReading reading;
    reading.mark.turn_rad = turn_rad;
    reading.T_robot_sonar = Pose2(0.0, 0.0, radians(degree));
    reading.range_m = tests::ideal_range_m(
        Pose2(0.1, 0.2, (1.0 + share) * turn_rad) * reading.T_robot_sonar, room);
    if (reading.range_m) {
      *reading.range_m += noise_m(random);
    }
    readings.push_back(reading);
  }
}

std::vector<StopReading> all_round(const tests::SmoothRoom& room, double turn_rad, double share) {
  std::mt19937 random(3);
  std::vector<StopReading> readings;
  for (const double part : {0.0, 0.5, 1.0}) {
    sweep(room, part * turn_rad, share, random, readings);
  }
  return readings;
}

TEST(TurnShare, IsWhatTheBodyTurnsMoreOrLessThanOdometrySays) {
  for (const double share : {-0.14, -0.09, -0.03, 0.0, 0.004, 0.05, 0.1, 0.14}) {
    for (const double turn_rad : {kFullTurn, -kFullTurn}) {
      const auto found = turn_share(all_round(tests::smooth_rectangle(), turn_rad, share), {});
      ASSERT_TRUE(found) << share;
      EXPECT_NEAR(*found, share, 0.003);
    }
  }
}

TEST(TurnShare, IsUnknownBeyondWhatIsTried) {
  for (const double share : {-0.17, 0.17}) {
    EXPECT_FALSE(turn_share(all_round(tests::smooth_rectangle(), kFullTurn, share), {})) << share;
  }
}

TEST(TurnShare, RefusesParametersWithoutSense) {
  EXPECT_THROW(validate(TurnCalibrationParams{.step_rad = 0.0}), std::invalid_argument);
  EXPECT_THROW(validate(TurnCalibrationParams{.range_stddev_m = 0.0}), std::invalid_argument);
}

TEST(TurnShare, IsUnknownWhereTheStopIsNotAllRound) {
  EXPECT_FALSE(turn_share(all_round(tests::smooth_rectangle(), 3.0, 0.05), {}));
  EXPECT_FALSE(turn_share({}, {}));
}

TEST(TurnShare, IsUnknownWhereNothingAnswers) {
  EXPECT_FALSE(turn_share(all_round({}, kFullTurn, 0.05), {}));
}

TEST(TurnShare, IsUnknownWhereEveryDirectionSoundsTheSame) {
  tests::SmoothRoom round;
  for (int degree = 0; degree < 360; degree += 5) {
    round.walls.push_back(
        {radians(degree), 1.0 + 0.1 * std::cos(radians(degree)) + 0.2 * std::sin(radians(degree))});
  }
  EXPECT_FALSE(turn_share(all_round(round, kFullTurn, 0.05), {}));
}

}  // namespace
}  // namespace echomap::slam
