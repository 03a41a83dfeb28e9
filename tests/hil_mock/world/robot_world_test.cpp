// SPDX-License-Identifier: MIT
#include "hil_mock/world/robot_world.hpp"

#include <numbers>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "tests/hil_mock/world/rooms.hpp"

namespace echomap::world {
namespace {

struct Trace {
  std::vector<double> values;
  bool operator==(const Trace&) const = default;
};

Trace drive_and_ping(std::uint32_t seed, int extra_pings) {
  RobotWorld world(box_room(), RobotParams{}, seed);
  EncoderChanges changes;
  Trace trace;
  for (int i = 0; i < 300; ++i) {
    world.step(0.001, {0.5, 0.7}, changes);
    if (i % 50 == 0) {
      for (int k = 0; k < 1 + extra_pings; ++k) {
        world.ping(0.1 * k);
      }
    }
  }
  trace.values = {world.T_world_robot().x_m(),
                  world.T_world_robot().y_m(),
                  world.T_world_robot().heading_rad()};
  return trace;
}

TEST(RobotWorld, IsAFunctionOfItsSeed) {
  EXPECT_EQ(drive_and_ping(3, 0), drive_and_ping(3, 0));
  EXPECT_FALSE(drive_and_ping(3, 0) == drive_and_ping(4, 0));
}

TEST(RobotWorld, PingsDoNotChangeHowTheBodyMoves) {
  EXPECT_EQ(drive_and_ping(3, 0), drive_and_ping(3, 5));
}

TEST(RobotWorld, FlightTimeIsThereAndBackFromTheMount) {
  RobotParams robot;
  robot.sonar.range_noise_m = 0.0;
  RobotWorld world(box_room(), robot, 1);
  const double ahead_m = 4.0 - 2.0 - 0.03;
  EXPECT_NEAR(world.ping(0.0).value(), 2.0 * ahead_m / 343.2, 1e-9);
  EXPECT_NEAR(world.ping(0.5 * std::numbers::pi).value(), 2.0 * 1.5 / 343.2, 1e-9);
}

TEST(RobotWorld, CanBePutElsewhere) {
  RobotParams robot;
  robot.sonar.range_noise_m = 0.0;
  RobotWorld world(box_room(), robot, 1);
  world.place({1.0, 1.0, std::numbers::pi});
  EXPECT_NEAR(world.ping(0.0).value(), 2.0 * 0.97 / 343.2, 1e-9);
}

}  // namespace
}  // namespace echomap::world
