// SPDX-License-Identifier: MIT
#include <cmath>

#include <gtest/gtest.h>

#include "tests/host/robot_link/link_fixture.hpp"

namespace echomap::robot_link {
namespace {

using LinkClock = LinkFixture;

/// Milliseconds by which the clock misplaces the robot's present.
double error_ms(const RobotLink& link, const FakeRobot& robot, int now_ms) {
  const auto estimate = link.clock().host_time(robot.stamp_us());
  const auto instant_us = estimate->instant.time_since_epoch().count();
  // The last step of the fixture took place one millisecond before `now_ms`.
  return std::abs(static_cast<double>(instant_us) * 1e-3 - (now_ms - 1));
}

TEST_F(LinkClock, PingsOnlyWhenReady) {
  robot_has_power = false;
  run_for(2000);
  EXPECT_FALSE(link.clock().host_time(0));
  robot_has_power = true;
  robot.power_on(1);
  run_for(30'000);
  EXPECT_NEAR(robot.pings, 385 + 25, 20);
}

TEST_F(LinkClock, PlacesTheRobotsStamps) {
  robot.power_on(1);
  run_for(5000);
  EXPECT_LE(error_ms(link, robot, now_ms), 0.5);
  EXPECT_NEAR(link.clock().host_time(0)->asymmetry_us, 2000.0, 600.0);
}

TEST_F(LinkClock, HoldsWhereFramesAreLost) {
  to_robot.faults = {0.05, 0.05, 0.05};
  to_host.faults = {0.05, 0.05, 0.05};
  robot.power_on(1);
  run_for(20'000);
  EXPECT_LE(error_ms(link, robot, now_ms), 0.5);
}

TEST_F(LinkClock, StartsAnewWhenTheRobotWasReset) {
  robot.power_on(1);
  run_for(8000);
  robot.power_on(2);
  run_for(5000);
  EXPECT_LE(error_ms(link, robot, now_ms), 0.5);
}

TEST_F(LinkClock, NeedsPings) {
  robot.answers_pings = false;
  robot.power_on(1);
  run_for(5000);
  EXPECT_EQ(link.state(), LinkState::kReady);
  EXPECT_FALSE(link.clock().host_time(0));
}

TEST_F(LinkClock, StartsAnewAfterAnOutageOfMoreThanItsWindow) {
  run_for(5000);
  to_host.is_cut = true;
  run_for(70'000);
  ASSERT_TRUE(link.clock().uncertainty_us());
  to_host.is_cut = false;
  while (link.state() != LinkState::kReady) {
    run_for(1);
  }
  EXPECT_FALSE(link.clock().uncertainty_us());
  run_for(2000);
  EXPECT_TRUE(link.clock().uncertainty_us());
  EXPECT_EQ(link.statistics().outages, 1U);
  EXPECT_GT(link.statistics().outage_time, std::chrono::seconds(68));
}

}  // namespace
}  // namespace echomap::robot_link
