// SPDX-License-Identifier: MIT
#include "hil_mock/runner/simulated_board.hpp"

#include <gtest/gtest.h>

#include "tests/hil_mock/runner/fake_board.hpp"

namespace echomap::runner {
namespace {

TEST(SimulatedBoard, MotorsGetWhatTheirDriversMakeOfItsPins) {
  FakeBoard board;
  board.duty = {0.75, -0.25};
  const MotorDuty braking = board.motor_duty(world::MotorDriver(world::DriverChip::kTb6612fng));
  EXPECT_EQ(braking.left, 0.75);
  EXPECT_EQ(braking.right, -0.25);
  EXPECT_EQ(braking.left_coasting, 0.0);
  const MotorDuty coasting = board.motor_duty(world::MotorDriver(world::DriverChip::kL298n));
  EXPECT_EQ(coasting.left, 0.75);
  EXPECT_EQ(coasting.left_coasting, 0.25);
  EXPECT_EQ(coasting.right_coasting, 0.75);
}

TEST(SimulatedBoard, MotorsHaveAPhaseEnableDriverWhereNoOtherIsNamed) {
  FakeBoard board;
  board.duty = {1.0, -0.5};
  EXPECT_EQ(board.motor_duty().left, 1.0);
  EXPECT_EQ(board.motor_duty().right, -0.5);
  EXPECT_EQ(board.motor_duty().right_coasting, 0.0);
}

}  // namespace
}  // namespace echomap::runner
