// SPDX-License-Identifier: MIT
#include "host/exploration/coastal.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"

namespace echomap::exploration {
namespace {

using geometry::degrees;

/// What the explorer sees of walls.
pipeline::Snapshot felt(const WallContact& contact, const geometry::Pose2& T_map_robot = {}) {
  pipeline::Snapshot snapshot;
  snapshot.latest.T_map_robot = T_map_robot;
  snapshot.hazards.bump_left = contact.bumped;
  snapshot.hazards.virtual_wall = contact.wall_ahead;
  snapshot.hazards.wall = contact.wall_beside;
  snapshot.infrared.range_m = {contact.range_m};
  return snapshot;
}

constexpr WallContact kNothing{};
constexpr WallContact kBump{true, true, false, {}};
constexpr WallContact kWall{false, false, true, 0.09};
constexpr WallContact kTooNear{false, false, true, 0.07};

Roll answer(Coastal& coastal, const WallContact& contact) {
  return std::get<Roll>(coastal.next(felt(contact), MotionResult::kReached));
}

TEST(Coastal, GoesForwardAtThePapersSpeedAndTickUntilItFindsAWall) {
  Coastal coastal(CoastalParams{});
  const Roll roll = answer(coastal, kNothing);
  EXPECT_EQ(roll.forward_m_per_s, 0.06);
  EXPECT_EQ(roll.turn_rad_per_s, 0.0);
  EXPECT_EQ(roll.for_s, 0.07);
  EXPECT_TRUE(coastal.steps().empty());
  answer(coastal, kBump);
  EXPECT_EQ(coastal.steps().size(), 1U);
}

TEST(Coastal, SpinsLeftBy25DegreesAtABump) {
  Coastal coastal(CoastalParams{});
  const Roll roll = answer(coastal, kBump);
  EXPECT_EQ(roll.forward_m_per_s, 0.0);
  EXPECT_NEAR(degrees(roll.turn_rad_per_s * roll.for_s), 25.0, 1e-9);
}

TEST(Coastal, TurnsRightOnAnArcWhereItLosesTheWall) {
  Coastal coastal(CoastalParams{});
  EXPECT_EQ(answer(coastal, kWall).turn_rad_per_s, 0.0);
  const Roll roll = answer(coastal, kNothing);
  EXPECT_NEAR(roll.forward_m_per_s / roll.turn_rad_per_s, -0.20, 1e-12);
  EXPECT_EQ(roll.for_s, 0.07);
}

TEST(Coastal, BearsAwayFromAWallThatItWouldScrapeAlong) {
  Coastal coastal(CoastalParams{});
  EXPECT_GT(answer(coastal, kTooNear).turn_rad_per_s, 0.0);
  CoastalParams to_the_word;
  to_the_word.min_gap_m = 0.0;
  Coastal paper(to_the_word);
  EXPECT_EQ(answer(paper, kTooNear).turn_rad_per_s, 0.0);
}

TEST(Coastal, DoesAllOfItTheOtherWayRoundWithTheLeftHand) {
  CoastalParams params;
  params.hand = Hand::kLeft;
  EXPECT_THROW(Coastal{params}, std::invalid_argument) << "the sensor is on the right";
  params.T_robot_sensor = mirrored(params.T_robot_sensor);
  Coastal left(params);
  Coastal right(CoastalParams{});
  for (const WallContact& contact : {kBump, kWall, kNothing, kTooNear}) {
    const Roll theirs = answer(left, contact);
    const Roll ours = answer(right, contact);
    EXPECT_EQ(theirs.forward_m_per_s, ours.forward_m_per_s);
    EXPECT_EQ(theirs.turn_rad_per_s, -ours.turn_rad_per_s);
  }
}

/// Drives round a square of the given half side about the start, the wall always there; the
/// answer's end, empty where there is none.
std::optional<FinishReason> walk_square(Coastal& coastal, double half_m, int sides) {
  geometry::Pose2 pose(half_m, 0.0, geometry::radians(90.0));
  for (int side = 0; side <= sides; ++side) {
    const double travelled_m = side == 0 || side == sides ? half_m : 2.0 * half_m;
    for (double at_m = 0.0; at_m < travelled_m; at_m += 0.02) {
      const Motion motion = coastal.next(felt(kWall, pose), MotionResult::kReached);
      if (const auto* finished = std::get_if<Finished>(&motion)) {
        return finished->reason;
      }
      pose = pose * geometry::Pose2(0.02, 0.0, 0.0);
    }
    coastal.next(felt(kBump, pose), MotionResult::kBumped);
    pose = pose * geometry::Pose2(0.0, 0.0, geometry::radians(90.0));
  }
  return std::nullopt;
}

TEST(Coastal, GoesOnPastACornerForTheSecondTime) {
  Coastal coastal(CoastalParams{});
  EXPECT_FALSE(walk_square(coastal, 1.0, 4));
  Coastal farther(CoastalParams{});
  EXPECT_EQ(walk_square(farther, 1.0, 6), FinishReason::kComplete);
  EXPECT_EQ(farther.traversal().state(), Traversal::kRoundRoom);
  EXPECT_NEAR(farther.steps().back().travelled_m, 8.0 + 1.0 + 0.5, 0.2);
}

TEST(Coastal, EndsByThePapersAngleWhereItIsTold) {
  CoastalParams params;
  params.rule = TraversalRule::kAngleAboutStart;
  Coastal coastal(params);
  EXPECT_EQ(walk_square(coastal, 1.0, 6), FinishReason::kComplete);
  EXPECT_NEAR(coastal.steps().back().travelled_m, 8.0, 0.1);
}

TEST(Coastal, GivesUpAfterTooLongAWay) {
  CoastalParams params;
  params.max_distance_m = 3.0;
  Coastal coastal(params);
  EXPECT_EQ(walk_square(coastal, 1.0, 4), FinishReason::kNowhereToGo);
}

TEST(Coastal, HasNoOutlineBeforeItHasComeRound) {
  Coastal coastal(CoastalParams{});
  walk_square(coastal, 1.0, 2);
  EXPECT_TRUE(coastal.products().outline_m.empty());
}

TEST(Coastal, RefusesParametersWithoutSense) {
  CoastalParams params;
  params.tick_s = 0.0;
  EXPECT_THROW(Coastal{params}, std::invalid_argument);
}

}  // namespace
}  // namespace echomap::exploration
