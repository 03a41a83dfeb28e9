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

TEST(RobotWorld, KnowsPlacesElsewhereWithRoomForTheRobot) {
  RobotWorld world(box_room(), RobotParams{}, 5);
  for (int i = 0; i < 20; ++i) {
    const geometry::Pose2 before = world.T_world_robot();
    const geometry::Pose2 place = world.somewhere_else();
    EXPECT_TRUE(world.fits(place.position_m(), 0.05)) << i;
    EXPECT_GT((place.position_m() - before.position_m()).norm(), 1.0) << i;
    world.place(place);
  }
  RobotWorld twin(box_room(), RobotParams{}, 5);
  RobotWorld other(box_room(), RobotParams{}, 6);
  const geometry::Pose2 first = RobotWorld(box_room(), RobotParams{}, 5).somewhere_else();
  EXPECT_EQ(twin.somewhere_else().position_m(), first.position_m());
  EXPECT_NE(other.somewhere_else().position_m(), first.position_m());
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

/// All that a robot can carry, at work; what it does to body and sonar shows in the trace.
TEST(RobotWorld, PartsDoNotChangeHowTheBodyMovesAndWhatTheSonarHears) {
  const auto trace = [](const RobotParams& robot) {
    RobotWorld world(box_room(), robot, 5);
    EncoderChanges changes;
    std::vector<double> values;
    for (int i = 0; i < 300; ++i) {
      world.step(0.001, {0.5, 0.7}, changes);
      world.parts().millivolts(PinPart::kBattery);
      values.push_back(world.T_world_robot().heading_rad());
      values.push_back(world.ping(0.001 * i).value_or(0.0));
    }
    return values;
  };
  RobotParams equipped;
  equipped.parts.ranges = {{0, IrKind::kEpuck, {}}};
  equipped.parts.gyro = GyroParams{};
  equipped.parts.battery = BatteryParams{};
  EXPECT_EQ(trace({}), trace(equipped));
}

TEST(RobotWorld, WithAWheelOverAHoleItIsStuck) {
  const FloorPlan stairs("stairs",
                         {rectangle(0.0, 0.0, 4.0, 3.0), {}},
                         {},
                         {2.0, 1.5, 0.0},
                         {{rectangle(3.0, 0.0, 4.0, 3.0)}, {}});
  RobotWorld world(stairs, {}, 1);
  EncoderChanges changes;
  for (int i = 0; i < 6000; ++i) {
    world.step(0.001, {0.5, 0.5}, changes);
  }
  EXPECT_FALSE(world.body().support().left && world.body().support().right);
  const Eigen::Vector2d stuck_m = world.T_world_robot().position_m();
  EXPECT_NEAR(stuck_m.x(), 3.0, 0.07) << "half a track";
  for (int i = 0; i < 1000; ++i) {
    world.step(0.001, {-0.5, -0.5}, changes);
  }
  EXPECT_EQ(world.T_world_robot().position_m(), stuck_m) << "it turns its wheels in the air";
}

TEST(RobotWorld, LiftedItsWheelsTurnAndItStays) {
  RobotWorld world(box_room(), {}, 1);
  world.lift();
  EncoderChanges changes;
  for (int i = 0; i < 500; ++i) {
    world.step(0.001, {0.5, 0.5}, changes);
  }
  EXPECT_EQ(world.T_world_robot().x_m(), 2.0);
  EXPECT_GT(world.body().left_wheel().counts(), 500);
  world.place({1.0, 1.0, 0.0});
  world.step(0.001, {0.5, 0.5}, changes);
  EXPECT_GT(world.T_world_robot().x_m(), 1.0);
}

}  // namespace
}  // namespace echomap::world
