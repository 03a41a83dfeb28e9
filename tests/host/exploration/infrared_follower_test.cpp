// SPDX-License-Identifier: MIT
#include "host/exploration/infrared_follower.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/host/exploration/infrared_ring.hpp"

namespace echomap::exploration {
namespace {

InfraredFollower follower() { return InfraredFollower(ring_params()); }

TEST(InfraredFollower, GoesStraightAtItsDistance) {
  auto along = follower();
  along.follow(ranges({{kBeside, 0.018}}));
  const Roll roll = along.follow(ranges({{kBeside, 0.018}}));
  EXPECT_EQ(roll.forward_m_per_s, 0.05);
  EXPECT_EQ(roll.turn_rad_per_s, 0.0);
}

TEST(InfraredFollower, TurnsToTheWallWhereItIsTooFarAndAwayWhereItIsTooNear) {
  auto far = follower();
  EXPECT_LT(far.follow(ranges({{kBeside, 0.028}})).turn_rad_per_s, 0.0);
  auto near = follower();
  EXPECT_GT(near.follow(ranges({{kBeside, 0.010}})).turn_rad_per_s, 0.0);
}

// At its distance, but coming nearer.
TEST(InfraredFollower, TurnsAgainstItsApproach) {
  auto along = follower();
  along.follow(ranges({{kBeside, 0.020}}));
  EXPECT_GT(along.follow(ranges({{kBeside, 0.018}})).turn_rad_per_s, 0.0);
  along.forget();
  EXPECT_EQ(along.follow(ranges({{kBeside, 0.018}})).turn_rad_per_s, 0.0);
}

TEST(InfraredFollower, GoesRoundAnEdgeAtItsDistance) {
  auto along = follower();
  const Roll roll = along.follow(ranges({}));
  EXPECT_NEAR(roll.forward_m_per_s / -roll.turn_rad_per_s, 0.037 + 0.018, 1e-12);
}

TEST(InfraredFollower, SpinsLeftFromWhatIsAheadOrAslant) {
  for (const std::size_t sensor : {kAhead, kAheadLeft, kOblique}) {
    auto along = follower();
    const auto seen = ranges({{sensor, 0.015}, {kBeside, 0.018}});
    EXPECT_TRUE(along.is_blocked(seen));
    const Roll roll = along.follow(seen);
    EXPECT_EQ(roll.forward_m_per_s, 0.0);
    EXPECT_GT(roll.turn_rad_per_s, 0.0);
  }
  EXPECT_FALSE(follower().is_blocked(ranges({{kBeside, 0.01}, {kObliqueLeft, 0.01}})));
}

TEST(InfraredFollower, KnowsASideThatItGrazes) {
  EXPECT_TRUE(follower().grazes_right(ranges({{kBeside, 0.01}})));
  EXPECT_FALSE(follower().grazes_left(ranges({{kBeside, 0.01}})));
  EXPECT_TRUE(follower().grazes_left(ranges({{kObliqueLeft, 0.01}})));
  EXPECT_FALSE(follower().grazes_left(ranges({{kObliqueLeft, 0.05}})));
  EXPECT_GT(follower().spin().turn_rad_per_s, 0.0);
}

TEST(InfraredFollower, NeedsSensorsAheadAndToTheRight) {
  InfraredFollowerParams params = ring_params();
  params.T_robot_sensor.clear();
  EXPECT_THROW(InfraredFollower{params}, std::invalid_argument);
  params = ring_params();
  params.speed_m_per_s = 0.0;
  EXPECT_THROW(InfraredFollower{params}, std::invalid_argument);
}

}  // namespace
}  // namespace echomap::exploration
