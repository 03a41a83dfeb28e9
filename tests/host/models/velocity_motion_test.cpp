// SPDX-License-Identifier: MIT
#include "host/models/velocity_motion.hpp"

#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"

namespace echomap::models {
namespace {

using geometry::Pose2;

TEST(VelocityMotion, DrivesTheArcThatWasCommanded) {
  // A quarter of a circle of 0.5 m.
  const double quarter_rad = std::numbers::pi / 2.0;
  const Pose2 there = VelocityMotion().sample({0.25 * quarter_rad, 0.5 * quarter_rad, 2.0});
  EXPECT_NEAR(there.x_m(), 0.5, 1e-12);
  EXPECT_NEAR(there.y_m(), 0.5, 1e-12);
  EXPECT_NEAR(there.heading_rad(), quarter_rad, 1e-12);
}

TEST(VelocityMotion, IsSmoothWhereAnArcBecomesStraight) {
  const VelocityMotion motion;
  for (const double turn_rad_per_s : {0.0, 1e-10, 1e-9, 1e-8, -1e-8}) {
    const Pose2 there = motion.sample({0.3, turn_rad_per_s, 2.0});
    EXPECT_NEAR(there.x_m(), 0.6, 1e-9) << turn_rad_per_s;
    EXPECT_NEAR(there.y_m(), 0.0, 1e-7) << turn_rad_per_s;
  }
}

TEST(VelocityMotion, IsTheSumOfItsParts) {
  const VelocityMotion motion;
  const Pose2 whole = motion.sample({0.2, -0.7, 3.0});
  Pose2 parts;
  for (int i = 0; i < 10; ++i) {
    parts = parts * motion.sample({0.2, -0.7, 0.3});
  }
  EXPECT_LT((whole.position_m() - parts.position_m()).norm(), 1e-12);
  EXPECT_NEAR(geometry::angle_between(whole.heading_rad(), parts.heading_rad()), 0.0, 1e-12);
}

TEST(VelocityMotion, SpreadsByTheVariancesOfTableFiveThree) {
  const VelocityMotion motion({.speed_by_speed = 0.01,
                               .speed_by_turn_m2_per_rad2 = 0.002,
                               .turn_by_speed_rad2_per_m2 = 0.003,
                               .turn_by_turn = 0.004,
                               .final_by_speed_rad2_per_m2 = 0.005,
                               .final_by_turn = 0.006});
  const VelocityCommand command{0.5, 0.2, 1.5};
  const Pose2 exact = motion.sample(command);
  const double turn_rad = motion.sample(command, {.turn = 1.0}).heading_rad() - exact.heading_rad();
  EXPECT_NEAR(turn_rad, 1.5 * std::sqrt(0.003 * 0.25 + 0.004 * 0.04), 1e-12);
  const double final_rad =
      motion.sample(command, {.final_turn = 1.0}).heading_rad() - exact.heading_rad();
  EXPECT_NEAR(final_rad, 1.5 * std::sqrt(0.005 * 0.25 + 0.006 * 0.04), 1e-12);
  const double scale =
      motion.sample(command, {.speed = 1.0}).position_m().norm() / exact.position_m().norm();
  EXPECT_NEAR(scale, 1.0 + std::sqrt(0.01 * 0.25 + 0.002 * 0.04) / 0.5, 1e-12);
}

TEST(VelocityMotion, TheFinalTurnLeavesThePlaceAlone) {
  const VelocityMotion motion;
  const VelocityCommand command{0.5, 0.2, 1.5};
  EXPECT_EQ(motion.sample(command, {.final_turn = 2.0}).position_m(),
            motion.sample(command).position_m());
}

TEST(VelocityMotion, SpreadOfTheChordIsThatOfTheArc) {
  const VelocityMotion motion;
  const VelocityCommand command{0.3, 0.4, 1.0};
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  const Pose2 exact = motion.sample(command);
  const OdometryStep step = odometry_step({}, exact);
  const Pose2 T_chord_start = Pose2(0.0, 0.0, -step.turn_before_rad);
  constexpr int kSamples = 100'000;
  double along = 0.0;
  double aside = 0.0;
  double heading = 0.0;
  for (int i = 0; i < kSamples; ++i) {
    const Pose2 there = motion.sample(command, {normal(random), normal(random), normal(random)});
    const Eigen::Vector2d off_m =
        T_chord_start * Eigen::Vector2d(there.position_m() - exact.position_m());
    along += off_m.x() * off_m.x() / kSamples;
    aside += off_m.y() * off_m.y() / kSamples;
    heading += std::pow(there.heading_rad() - exact.heading_rad(), 2) / kSamples;
  }
  const MotionSpread spread = motion.spread(step);
  EXPECT_NEAR(spread.drive_m, std::sqrt(along), 0.03 * spread.drive_m);
  EXPECT_NEAR(step.drive_m * spread.turn_before_rad, std::sqrt(aside), 0.03 * std::sqrt(aside));
  EXPECT_NEAR(std::hypot(spread.turn_before_rad, spread.turn_after_rad),
              std::sqrt(heading),
              0.03 * std::sqrt(heading));
}

TEST(VelocityMotion, RefusesVariancesWithoutSense) {
  EXPECT_THROW(VelocityMotion({.speed_by_speed = -1.0}), std::invalid_argument);
  EXPECT_THROW(VelocityMotion({.final_by_turn = std::nan("")}), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::models
