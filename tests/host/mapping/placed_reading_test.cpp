// SPDX-License-Identifier: MIT
#include "host/mapping/placed_reading.hpp"

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"

namespace echomap::mapping {
namespace {

TEST(EchoPoint, LiesOnTheAxisOfTheBeam) {
  const geometry::Pose2 T_map_robot(1.0, 2.0, 0.0);
  const geometry::Pose2 T_robot_sonar(0.1, 0.0, geometry::radians(90.0));
  const PlacedReading reading{T_map_robot, T_map_robot * T_robot_sonar, 0.5};
  EXPECT_NEAR((echo_point_m(reading).value() - Eigen::Vector2d(1.1, 2.5)).norm(), 0.0, 1e-12);
}

TEST(EchoPoint, IsNowhereWithoutEcho) { EXPECT_FALSE(echo_point_m(PlacedReading{}).has_value()); }

TEST(MovedScan, KeepsItsShape) {
  const geometry::Pose2 T_robot_sonar(0.1, 0.0, geometry::radians(90.0));
  const Scan scan{{{}, T_robot_sonar, 0.5},
                  {{1.0, 0.0, 0.0}, {1.1, 0.0, 0.0}, std::nullopt, false}};
  const geometry::Pose2 T_to_from(1.0, 2.0, geometry::radians(90.0));
  const Scan there = moved(scan, T_to_from);
  ASSERT_EQ(there.size(), 2U);
  EXPECT_NEAR((echo_point_m(there[0]).value() - Eigen::Vector2d(0.5, 2.1)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((there[1].T_map_robot.position_m() - Eigen::Vector2d(1.0, 3.0)).norm(), 0.0, 1e-12);
  EXPECT_FALSE(there[1].range_m.has_value());
  EXPECT_TRUE(there[0].has_answered);
  EXPECT_FALSE(there[1].has_answered);
}

TEST(AnsweredScan, LacksWhatTheSonarDidNotAnswer) {
  const Scan scan{{{}, {}, 0.5}, {{}, {}, std::nullopt, false}, {{}, {}, std::nullopt}};
  const Scan rest = answered(scan);
  ASSERT_EQ(rest.size(), 2U);
  EXPECT_EQ(rest[0].range_m, 0.5);
  EXPECT_FALSE(rest[1].range_m.has_value());
}

}  // namespace
}  // namespace echomap::mapping
