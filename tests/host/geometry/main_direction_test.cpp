// SPDX-License-Identifier: MIT
#include "host/geometry/main_direction.hpp"

#include <numbers>

#include <gtest/gtest.h>

#include "host/geometry/pose2.hpp"
#include "host/geometry/unit_vector.hpp"

namespace echomap::geometry {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

std::vector<Segment> turned(const std::vector<Segment>& walls, double turn_rad) {
  const Pose2 T(0.7, -0.2, turn_rad);
  std::vector<Segment> turned;
  for (const Segment& wall : walls) {
    turned.push_back({T * wall.from_m, T * wall.to_m});
  }
  return turned;
}

TEST(MainDirection, IsHowFarARoomIsTurnedFromTheAxes) {
  const std::vector<Segment> room{{{0, 0}, {4, 0}}, {{4, 0}, {4, 3}}, {{4, 3}, {0, 3}}};
  EXPECT_NEAR(main_direction_rad(room), 0.0, 1e-12);
  for (const double turn_deg : {-44.0, -20.0, 1.0, 30.0, 44.0}) {
    EXPECT_NEAR(main_direction_rad(turned(room, turn_deg * kDegree)), turn_deg * kDegree, 1e-9);
    EXPECT_NEAR(
        main_direction_rad(turned(room, (turn_deg + 90.0) * kDegree)), turn_deg * kDegree, 1e-9);
  }
}

TEST(MainDirection, FollowsTheLongWalls) {
  const std::vector<Segment> room{{{0, 0}, {5, 0}}, {{5, 0}, {5, 4}}, {{0, 0}, {0.3, 0.2}}};
  EXPECT_NEAR(main_direction_rad(room), 0.0, 2.0 * kDegree);
}

TEST(MainDirection, IsThatOfTheAxesWhereNoneIsPreferred) {
  EXPECT_EQ(main_direction_rad({}), 0.0);
  EXPECT_EQ(main_direction_rad({{{1, 1}, {1, 1}}}), 0.0);
  std::vector<Segment> round;
  for (int i = 0; i < 48; ++i) {
    round.push_back({unit_vector(i * 7.5 * kDegree), unit_vector((i + 1) * 7.5 * kDegree)});
  }
  EXPECT_EQ(main_direction_rad(turned(round, 0.1)), 0.0);
}

}  // namespace
}  // namespace echomap::geometry
