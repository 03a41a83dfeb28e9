// SPDX-License-Identifier: MIT
#include "hil_mock/world/robot_parts.hpp"

#include <cmath>
#include <memory>

#include <gtest/gtest.h>

#include "hil_mock/world/robot_world.hpp"
#include "host/geometry/angle.hpp"
#include "tests/hil_mock/world/rooms.hpp"

namespace echomap::world {
namespace {

using geometry::radians;

/// No floor right of x = 3, a virtual wall along y = 2.5.
FloorPlan room_with_stairs_and_beam() {
  return {"stairs",
          {rectangle(0.0, 0.0, 4.0, 3.0), {}},
          {},
          {2.0, 1.5, 0.0},
          {{rectangle(3.0, 0.0, 4.0, 3.0)}, {{{0.0, 2.5}, 0.0, 4.0, radians(1.0)}}}};
}

RobotParams equipped() {
  RobotParams robot;
  robot.drive = {};
  robot.drive.slip_m_per_sqrt_m = 0.0;
  robot.parts.cliffs = {{CliffPlace::kLeft, {0.02, 0.08}},
                        {CliffPlace::kFrontLeft, {0.08, 0.03}},
                        {CliffPlace::kFrontRight, {0.08, -0.03}},
                        {CliffPlace::kRight, {0.02, -0.08}}};
  robot.parts.ranges = {{2, IrKind::kGp2y0a21, {0.0, 0.0, radians(90.0)}}};
  robot.parts.wall = WallSensorParams{{0.0, -0.05, radians(-90.0)}, 0.1};
  robot.parts.beam_detector = BeamDetectorParams{};
  robot.parts.gyro = GyroParams{0.0, 0.0, 0.0, 0.0};
  robot.parts.battery = BatteryParams{};
  return robot;
}

class RobotPartsTest : public testing::Test {
 protected:
  void put(double x_m, double y_m, double heading_deg) {
    world.place({x_m, y_m, radians(heading_deg)});
  }
  bool active(PinPart part) { return world.parts().is_active(part); }
  void run(int ms, const WheelDuty& duty) {
    EncoderChanges changes;
    for (int i = 0; i < ms; ++i) {
      world.step(0.001, duty, changes);
    }
  }

  RobotWorld world{room_with_stairs_and_beam(), equipped(), 1};
};

TEST_F(RobotPartsTest, EachCliffSensorAnswersForItself) {
  put(2.95, 1.5, 0.0);
  EXPECT_TRUE(active(PinPart::kCliffFrontLeft));
  EXPECT_TRUE(active(PinPart::kCliffFrontRight));
  EXPECT_FALSE(active(PinPart::kCliffLeft));
  put(2.95, 1.5, 90.0);
  EXPECT_TRUE(active(PinPart::kCliffRight));
  EXPECT_FALSE(active(PinPart::kCliffLeft));
  EXPECT_FALSE(active(PinPart::kCliffFrontLeft));
}

TEST_F(RobotPartsTest, ALiftedRobotSeesDepthEverywhereUntilItIsPlaced) {
  EXPECT_FALSE(active(PinPart::kWheelDrop) || active(PinPart::kCliffLeft));
  world.lift();
  for (const PinPart part : {PinPart::kCliffLeft,
                             PinPart::kCliffFrontLeft,
                             PinPart::kCliffFrontRight,
                             PinPart::kCliffRight,
                             PinPart::kWheelDrop}) {
    EXPECT_TRUE(active(part)) << static_cast<int>(part);
  }
  put(1.0, 1.0, 0.0);
  EXPECT_FALSE(active(PinPart::kWheelDrop) || active(PinPart::kCliffLeft));
}

TEST_F(RobotPartsTest, AWheelOverAHoleHasDropped) {
  put(2.95, 1.5, 90.0);
  EXPECT_TRUE(active(PinPart::kWheelDrop));
  put(2.9, 1.5, 90.0);
  EXPECT_FALSE(active(PinPart::kWheelDrop));
}

TEST_F(RobotPartsTest, TheSwitchesSeeWallAndVirtualWall) {
  EXPECT_FALSE(active(PinPart::kWall) || active(PinPart::kVirtualWall));
  put(2.0, 0.12, 0.0);
  EXPECT_TRUE(active(PinPart::kWall));
  put(2.0, 2.5, 0.0);
  EXPECT_TRUE(active(PinPart::kVirtualWall));
}

TEST_F(RobotPartsTest, VoltagesAreThoseOfTheirChannel) {
  put(2.0, 2.6, 0.0);
  run(1, {});
  EXPECT_NEAR(
      world.parts().millivolts(static_cast<PinPart>(static_cast<int>(PinPart::kRange0) + 2)),
      740.0,
      60.0);
  EXPECT_EQ(world.parts().millivolts(PinPart::kRange0), 0.0) << "there is no such channel";
  EXPECT_NEAR(world.parts().millivolts(PinPart::kBattery), 4190.0, 15.0);
}

TEST_F(RobotPartsTest, TheGyroIntegratesATurnOfTheBody) {
  world.parts().gyro()->write(0x6B, 0);
  double turned_deg = 0.0;
  for (int i = 0; i < 2000; ++i) {
    run(1, {i < 1500 ? -0.4 : 0.0, i < 1500 ? 0.4 : 0.0});
    turned_deg += world.parts().gyro()->gyro().rate_deg_per_s() * 0.001;
  }
  EXPECT_GT(turned_deg, 90.0);
  EXPECT_NEAR(
      geometry::angle_between(world.T_world_robot().heading_rad(), radians(turned_deg)), 0.0, 1e-3);
}

TEST_F(RobotPartsTest, AHandThatTurnsTheRobotIsNoRate) {
  put(1.0, 1.0, 170.0);
  run(1, {});
  EXPECT_EQ(world.parts().gyro()->gyro().rate_deg_per_s(), 0.0);
}

TEST_F(RobotPartsTest, DrivingDrainsTheBattery) {
  run(1, {});
  const double resting_v = world.parts().battery().value().volts();
  run(5, {1.0, 1.0});
  EXPECT_LT(world.parts().battery().value().volts(), resting_v - 0.3) << "starting";
  run(1000, {1.0, 1.0});
  EXPECT_NEAR(world.parts().battery().value().volts(), resting_v - 0.036, 0.01) << "at speed";
}

TEST(RobotParts, ABareRobotHasNone) {
  RobotWorld world(room_with_stairs_and_beam(), {}, 1);
  world.lift();
  EXPECT_FALSE(world.parts().is_active(PinPart::kCliffLeft));
  EXPECT_EQ(world.parts().millivolts(PinPart::kBattery), 0.0);
  EXPECT_EQ(world.parts().gyro(), nullptr);
}

}  // namespace
}  // namespace echomap::world
