// SPDX-License-Identifier: MIT
#include "firmware/hal/motors.hpp"

#include <gtest/gtest.h>

#include "firmware/boards/ev3/parts.hpp"
#include "firmware/hal/encoders.hpp"
#include "firmware/hal/servo.hpp"
#include "tests/firmware/boards/ev3/brick_folder.hpp"
#include "tests/firmware/boards/ev3/set_clock.hpp"

namespace echomap::hal {
namespace {

using tests::BrickFolder;

class Ev3MotorsTest : public testing::Test {
 protected:
  Ev3MotorsTest() {
    boards::open_motors(brick.sysfs().c_str());
    boards::reset_motors(false);
    tests::set_clock_us(tests::clock_of_test_us() + 100000);
  }

  static std::string take_command(const std::filesystem::path& motor) {
    const std::string command = BrickFolder::read(motor / "command");
    BrickFolder::write(motor / "command", std::string(16, ' '));
    return command;
  }

  BrickFolder brick;
  std::filesystem::path pan = brick.add_motor(2, "outA");
  std::filesystem::path left = brick.add_motor(1, "outB");
  std::filesystem::path right = brick.add_motor(0, "outC");
};

TEST_F(Ev3MotorsTest, StartResetsEveryMotorAndAnotherStartLeavesThePanItsPlace) {
  EXPECT_EQ(take_command(pan), "reset");
  EXPECT_EQ(take_command(left), "reset");
  EXPECT_EQ(take_command(right), "reset");
  boards::reset_motors(true);
  EXPECT_EQ(take_command(pan), "stop");
  EXPECT_EQ(take_command(left), "reset");
}

TEST_F(Ev3MotorsTest, RunDirectIsCommandedOnceAndAgainAfterAStop) {
  take_command(left);
  set_motor(Motor::kLeft, true, 255);
  EXPECT_EQ(take_command(left), "run-direct");
  EXPECT_EQ(BrickFolder::read(left / "duty_cycle_sp"), "100");
  set_motor(Motor::kLeft, true, 128);
  EXPECT_EQ(take_command(left), "");
  EXPECT_EQ(BrickFolder::read(left / "duty_cycle_sp"), "50");
  stop_motor(Motor::kLeft, false);
  EXPECT_EQ(take_command(left), "stop");
  EXPECT_EQ(BrickFolder::read(left / "stop_action"), "coast");
  set_motor(Motor::kLeft, false, 128);
  EXPECT_EQ(take_command(left), "run-direct");
  EXPECT_EQ(BrickFolder::read(left / "duty_cycle_sp"), "-50");
}

TEST_F(Ev3MotorsTest, BrakeIsAStopAction) {
  set_motor(Motor::kRight, true, 10);
  stop_motor(Motor::kRight, true);
  EXPECT_EQ(take_command(right), "stop");
  EXPECT_EQ(BrickFolder::read(right / "stop_action"), "brake");
  stop_motor(Motor::kRight, false);
  EXPECT_EQ(take_command(right), "stop");
  EXPECT_EQ(BrickFolder::read(right / "stop_action"), "coast");
}

TEST_F(Ev3MotorsTest, MicrosecondOfThePulseIsADegreeOfThePanMotor) {
  set_servo_pulse_us(2040);
  EXPECT_EQ(take_command(pan), "run-to-abs-pos");
  EXPECT_EQ(BrickFolder::read(pan / "position_sp"), "540");
  EXPECT_EQ(BrickFolder::read(pan / "stop_action"), "hold");
  set_servo_pulse_us(960);
  EXPECT_EQ(BrickFolder::read(pan / "position_sp"), "-540");
}

TEST_F(Ev3MotorsTest, CountsArePositionsModuloSixteenBitsAndAMillisecondOld) {
  BrickFolder::write(left / "position", "70000");
  BrickFolder::write(right / "position", "-5");
  EXPECT_EQ(read_encoders().left, 70000 - 65536);
  EXPECT_EQ(read_encoders().right, -5);
  EXPECT_EQ(encoders_read_at_us(), tests::clock_of_test_us() - 1000);
}

TEST_F(Ev3MotorsTest, CountsOfOneMomentAreReadOnce) {
  BrickFolder::write(left / "position", "1");
  EXPECT_EQ(read_encoders().left, 1);
  BrickFolder::write(left / "position", "2");
  tests::set_clock_us(tests::clock_of_test_us() + 499);
  EXPECT_EQ(read_encoders().left, 1);
  tests::set_clock_us(tests::clock_of_test_us() + 1);
  EXPECT_EQ(read_encoders().left, 2);
}

TEST_F(Ev3MotorsTest, AllStopWithoutABrake) {
  set_motor(Motor::kLeft, true, 255);
  boards::stop_all_motors();
  for (const auto& motor : {pan, left, right}) {
    EXPECT_EQ(take_command(motor), "stop");
    EXPECT_EQ(BrickFolder::read(motor / "stop_action"), "coast");
  }
}

}  // namespace
}  // namespace echomap::hal
