// SPDX-License-Identifier: MIT
#include "hil_mock/world/sonar_physics.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"
#include "tests/hil_mock/world/rooms.hpp"

namespace echomap::world {
namespace {

using geometry::Pose2;
using geometry::radians;

constexpr int kPings = 4000;

/// A hall whose walls are out of range, except for the one at x = 1.
FloorPlan single_wall(Material material) {
  return {"hall",
          {{{-50.0, -50.0}, {1.0, -50.0}, {1.0, 50.0}, {-50.0, 50.0}},
           {{Material::kSmooth}, {material}}},
          {},
          {0.0, 0.0, 0.0}};
}

/// Chance that a ping hears anything.
double heard_chance(const SonarPhysics& sonar, const Pose2& T_world_sonar) {
  double chance = 0.0;
  for (const SonarReturn& found : sonar.returns(T_world_sonar)) {
    chance = std::max(chance, found.strength);
  }
  return chance;
}

/// First angle, in degrees, from which the axis turned by it hears less than half of the pings.
double half_heard_deg(const SonarPhysics& sonar) {
  double angle_deg = 0.0;
  while (heard_chance(sonar, {0.0, 0.0, radians(angle_deg)}) > 0.5) {
    angle_deg += 0.25;
  }
  return angle_deg;
}

TEST(SonarPhysics, MeasuresThePerpendicularDistanceOfAWall) {
  const FloorPlan plan = single_wall(Material::kSmooth);
  const SonarPhysics sonar(plan, {});
  for (const double distance_m : {0.1, 0.5, 1.0, 2.5, 3.9}) {
    const auto first = sonar.first_return({1.0 - distance_m, 0.3, 0.0}, 0.5);
    ASSERT_TRUE(first) << distance_m;
    EXPECT_NEAR(first->range_m, distance_m, 1e-9);
    EXPECT_EQ(first->kind, ReturnKind::kWall);
  }
}

TEST(SonarPhysics, InsideItsConeAWallIsARegionOfConstantDepth) {
  const FloorPlan plan = single_wall(Material::kSmooth);
  const SonarPhysics sonar(plan, {});
  for (int turn_deg = -12; turn_deg <= 12; ++turn_deg) {
    const auto first = sonar.first_return({0.0, 0.0, radians(turn_deg)}, 0.3);
    ASSERT_TRUE(first) << turn_deg;
    EXPECT_NEAR(first->range_m, 1.0, 1e-4) << turn_deg;
  }
}

TEST(SonarPhysics, LosesASmoothWallBetween25And30DegreesOffTheAxis) {
  const FloorPlan plan = single_wall(Material::kSmooth);
  const SonarPhysics sonar(plan, {});
  const double lost_deg = half_heard_deg(sonar);
  EXPECT_GT(lost_deg, 25.0);
  EXPECT_LT(lost_deg, 30.0);
  EXPECT_GT(heard_chance(sonar, {0.0, 0.0, radians(15.0)}), 0.95);
  EXPECT_LT(heard_chance(sonar, {0.0, 0.0, radians(40.0)}), 0.02);
}

TEST(SonarPhysics, HearsARoughWallAtWiderAngles) {
  const FloorPlan plan = single_wall(Material::kRough);
  const SonarPhysics sonar(plan, {});
  EXPECT_GT(half_heard_deg(sonar), 50.0);
}

TEST(SonarPhysics, HearsTheNicheOfTwoWallsThatAreTooOblique) {
  const FloorPlan plan = box_room();
  const SonarPhysics sonar(plan, {});
  const Pose2 toward_corner(3.0, 2.0, radians(45.0));
  const auto first = sonar.first_return(toward_corner, 0.5);
  ASSERT_TRUE(first);
  EXPECT_EQ(first->kind, ReturnKind::kNiche);
  EXPECT_NEAR(first->range_m, std::sqrt(2.0), 1e-9);
}

TEST(SonarPhysics, AnEdgeAnswersMoreWeaklyThanANiche) {
  const FloorPlan plan = box_room({{rectangle(2.0, 1.0, 2.5, 1.5), {}}}, {0.5, 0.5, 0.0});
  const SonarPhysics sonar(plan, {});
  const Pose2 toward_edge(1.0, 0.2, std::atan2(0.8, 1.0));
  EXPECT_EQ(sonar.first_return(toward_edge, 0.3)->kind, ReturnKind::kEdge);
  EXPECT_NE(sonar.first_return(toward_edge, 0.5).value_or(SonarReturn{}).kind, ReturnKind::kEdge);
}

// A pole of 1 cm passes through the beam: it is seen in half of the pings at the half angle.
TEST(SonarPhysics, ASweepOverAPoleGivesBackTheConesWidth) {
  const FloorPlan plan(
      "hall",
      {rectangle(-50.0, -50.0, 50.0, 50.0), {}},
      {{rectangle(1.0, -0.005, 1.01, 0.005),
        {{Material::kRough}, {Material::kRough}, {Material::kRough}, {Material::kRough}}}},
      {0.0, 0.0, 0.0});
  for (const double beam_half_angle_deg : {10.0, 13.0, 15.0}) {
    const SonarPhysics sonar(plan, {.beam_half_angle_rad = radians(beam_half_angle_deg)});
    EXPECT_NEAR(half_heard_deg(sonar), beam_half_angle_deg, 1.0);
  }
}

TEST(SonarPhysics, WhatIsBehindAnObstacleIsNotHeard) {
  const FloorPlan plan = box_room({{rectangle(1.5, 0.5, 1.6, 2.5), {}}}, {1.0, 1.5, 0.0});
  const SonarPhysics sonar(plan, {});
  for (const SonarReturn& found : sonar.returns({1.0, 1.5, 0.0})) {
    if (found.kind != ReturnKind::kGhost) {
      EXPECT_LT(found.range_m, 0.6);
    }
  }
}

TEST(SonarPhysics, AsManyPingsAreHeardAsTheStrengthSays) {
  const FloorPlan plan = single_wall(Material::kSmooth);
  const SonarPhysics sonar(plan, {});
  NoiseStream noise(11, NoisePurpose::kSonar);
  const Pose2 T_world_sonar(0.0, 0.0, radians(26.0));
  int heard = 0;
  for (int i = 0; i < kPings; ++i) {
    heard += sonar.ping_m(T_world_sonar, noise).has_value() ? 1 : 0;
  }
  const double chance = heard_chance(sonar, T_world_sonar);
  EXPECT_GT(chance, 0.4);
  EXPECT_LT(chance, 0.9);
  EXPECT_NEAR(heard / static_cast<double>(kPings), chance, 0.03);
}

TEST(SonarPhysics, TwoMirrorsMakeAGhostAtTheLengthOfBothWays) {
  const FloorPlan plan("ghost",
                       {{{0.0, 0.0}, {4.0, 0.0}, {4.0, 1.0}, {2.0, 3.0}, {0.0, 3.0}}, {}},
                       {},
                       {1.0, 1.0, 0.0});
  // Along +x from (1, 2): the slanted wall x + y = 5 throws it down, at right angles to y = 0.
  const SonarPhysics sonar(plan, {.beam_half_angle_rad = radians(5.0)});
  const Pose2 T_world_sonar(1.0, 2.0, 0.0);
  EXPECT_FALSE(sonar.first_return(T_world_sonar, 0.3));
  const auto ghost = sonar.first_return(T_world_sonar, 0.2);
  ASSERT_TRUE(ghost);
  EXPECT_EQ(ghost->kind, ReturnKind::kGhost);
  EXPECT_NEAR(ghost->range_m, 2.0 + 2.0, 0.02);
  EXPECT_NEAR(heard_chance(sonar, T_world_sonar), SonarParams{}.ghost_strength, 0.01);
}

TEST(SonarPhysics, AnswersWithinItsRangeOnly) {
  const FloorPlan plan = single_wall(Material::kSmooth);
  const SonarPhysics sonar(plan, {.max_range_m = 2.3});
  EXPECT_TRUE(sonar.first_return({1.0 - 2.2, 0.0, 0.0}, 0.5));
  EXPECT_FALSE(sonar.first_return({1.0 - 2.4, 0.0, 0.0}, 0.5));
  EXPECT_FALSE(sonar.first_return({1.0 - 0.03, 0.0, 0.0}, 0.5));
}

TEST(SonarPhysics, ReadingsHaveTheNoiseOfTheProfile) {
  const FloorPlan plan = single_wall(Material::kSmooth);
  const SonarPhysics sonar(plan, {.range_noise_m = 0.03});
  NoiseStream noise(2, NoisePurpose::kSonar);
  double sum = 0.0;
  double squares = 0.0;
  int heard = 0;
  for (int i = 0; i < kPings; ++i) {
    if (const auto range_m = sonar.ping_m({0.0, 0.0, 0.0}, noise)) {
      sum += *range_m - 1.0;
      squares += (*range_m - 1.0) * (*range_m - 1.0);
      ++heard;
    }
  }
  ASSERT_GT(heard, kPings - 40);
  EXPECT_NEAR(sum / heard, 0.0, 0.0015);
  EXPECT_NEAR(std::sqrt(squares / heard), 0.03, 0.0015);
}

TEST(SonarPhysics, RefusesAConeThatIsNone) {
  const FloorPlan plan = box_room();
  EXPECT_THROW(SonarPhysics(plan, {.beam_half_angle_rad = 0.0}), std::invalid_argument);
  EXPECT_THROW(SonarPhysics(plan, {.min_range_m = 2.0, .max_range_m = 1.0}), std::invalid_argument);
}

TEST(SonarPhysics, HearsGlassOnlyWhereItsBeamMeetsItStraightOn) {
  const FloorPlan plan = single_wall(Material::kGlass);
  const SonarPhysics sonar(plan, {});
  const double lost_deg = half_heard_deg(sonar);
  EXPECT_GT(lost_deg, 10.0);
  EXPECT_LT(lost_deg, 20.0) << "a painted wall is lost between 25 and 30";
  EXPECT_NEAR(sonar.first_return({0.0, 0.3, 0.0}, 0.5)->range_m, 1.0, 1e-9);
}

}  // namespace
}  // namespace echomap::world
