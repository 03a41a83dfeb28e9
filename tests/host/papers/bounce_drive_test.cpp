// SPDX-License-Identifier: MIT
#include "host/papers/bounce_drive.hpp"

#include <gtest/gtest.h>

#include "host/papers/contact_localization.hpp"

namespace echomap::papers {
namespace {

TEST(BounceRobot, StaysInTheRoomAndTurnsWhereItBumps) {
  BounceRobot robot(contact_room(), 3);
  for (int i = 0; i < 200; ++i) {
    robot.step(0.15);
    EXPECT_TRUE(contact_room().is_free(robot.T_world_robot().position_m())) << i;
  }
  EXPECT_GT(robot.bumps(), 10);
}

TEST(BounceRobot, DoesNotNoticeThatItIsCarriedOff) {
  BounceRobot robot(contact_room(), 3);
  robot.step(0.15);
  const auto odometry = robot.T_odom_robot();
  const auto truth = robot.T_world_robot();
  robot.be_carried_off();
  EXPECT_EQ(robot.T_odom_robot().position_m(), odometry.position_m());
  EXPECT_GT((robot.T_world_robot().position_m() - truth.position_m()).norm(), 0.05);
}

TEST(WheelErrors, AreSmallAndStayForARun) {
  const world::RobotParams robot = create_robot();
  world::NoiseStream noise(1, world::NoisePurpose::kBody);
  WheelErrors errors(robot.drive, noise);
  double sum_m = 0.0;
  for (int i = 0; i < 100; ++i) {
    sum_m += errors.measured(0.0, 1.0).x_m();
  }
  EXPECT_NEAR(sum_m, 100.0, 5.0);
  EXPECT_NEAR(errors.measured(1.5, 0.0).heading_rad(), 1.5, 0.1);
}

}  // namespace
}  // namespace echomap::papers
