// SPDX-License-Identifier: MIT
#include "firmware/hal/motors.hpp"

#include <gtest/gtest.h>

#include "firmware/boards/ev3/parts.hpp"
#include "firmware/hal/encoders.hpp"
#include "firmware/hal/servo.hpp"
#include "tests/firmware/boards/ev3/brick_folder.hpp"
#include "tests/firmware/boards/ev3/refused_writes.hpp"
#include "tests/firmware/boards/ev3/set_clock.hpp"

namespace echomap::hal {
namespace {

using tests::BrickFolder;
using tests::RefusedWrites;

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

TEST_F(Ev3MotorsTest, RefusedStopIsWrittenAgainUntilItIsTaken) {
  set_motor(Motor::kLeft, true, 255);
  take_command(left);
  {
    const RefusedWrites refused(2);
    stop_motor(Motor::kLeft, false);
    boards::repeat_refused_stops();
    EXPECT_EQ(refused.left(), 0);
  }
  EXPECT_EQ(take_command(left), "");
  boards::repeat_refused_stops();
  EXPECT_EQ(take_command(left), "stop");
  boards::repeat_refused_stops();
  EXPECT_EQ(take_command(left), "");
}

TEST_F(Ev3MotorsTest, RefusedStopDoesNotStopAMotorThatIsToRunAgain) {
  set_motor(Motor::kLeft, true, 255);
  take_command(left);
  {
    const RefusedWrites refused(1);
    stop_motor(Motor::kLeft, false);
  }
  set_motor(Motor::kLeft, true, 128);
  boards::repeat_refused_stops();
  EXPECT_EQ(take_command(left), "");
  EXPECT_EQ(BrickFolder::read(left / "duty_cycle_sp"), "50");
}

TEST_F(Ev3MotorsTest, RefusedBrakeIsSetAgain) {
  set_motor(Motor::kRight, true, 10);
  {
    const RefusedWrites refused(1);
    stop_motor(Motor::kRight, true);
  }
  EXPECT_EQ(BrickFolder::read(right / "stop_action"), "coast");
  boards::repeat_refused_stops();
  EXPECT_EQ(BrickFolder::read(right / "stop_action"), "brake");
  EXPECT_EQ(take_command(right), "stop");
}

TEST_F(Ev3MotorsTest, RefusedRunAndRefusedDutyAreWrittenByTheNextSetting) {
  take_command(left);
  {
    const RefusedWrites refused(1);
    set_motor(Motor::kLeft, true, 255);
  }
  EXPECT_EQ(take_command(left), "") << "it would run at another duty";
  set_motor(Motor::kLeft, true, 255);
  EXPECT_EQ(take_command(left), "run-direct");
  {
    const RefusedWrites refused(1);
    set_motor(Motor::kLeft, true, 128);
  }
  EXPECT_EQ(BrickFolder::read(left / "duty_cycle_sp"), "100");
  set_motor(Motor::kLeft, true, 128);
  EXPECT_EQ(BrickFolder::read(left / "duty_cycle_sp"), "50");
}

TEST_F(Ev3MotorsTest, RefusedResetBecomesAStop) {
  BrickFolder::write(left / "stop_action", "hold ");
  take_command(left);
  {
    const RefusedWrites refused(3);
    boards::reset_motors(false);
    EXPECT_EQ(refused.left(), 0);
  }
  boards::repeat_refused_stops();
  EXPECT_EQ(take_command(left), "stop");
  EXPECT_EQ(BrickFolder::read(left / "stop_action"), "coast");
}

TEST_F(Ev3MotorsTest, AllStopIsWrittenTwiceWhereItIsRefused) {
  {
    const RefusedWrites refused(3);  // stop_action twice, command once.
    boards::stop_all_motors();
    EXPECT_EQ(refused.left(), 0);
  }
  for (const auto& motor : {pan, left, right}) {
    EXPECT_EQ(take_command(motor), "stop");
  }
}

TEST_F(Ev3MotorsTest, MotorThatThisUserMayNotDriveCountsAsAbsentAndIsTold) {
  // Root may write into every file, but not into a folder.
  std::filesystem::remove(left / "command");
  std::filesystem::create_directory(left / "command");
  testing::internal::CaptureStderr();
  boards::open_motors(brick.sysfs().c_str());
  EXPECT_EQ(testing::internal::GetCapturedStderr(),
            "echomap-ev3: the motor at outB may not be driven: is the user in the group ev3dev?\n");
  const auto before = read_encoders().left;
  BrickFolder::write(left / "position", std::to_string(before + 7));
  tests::set_clock_us(tests::clock_of_test_us() + 1000);
  EXPECT_EQ(read_encoders().left, before);
  set_motor(Motor::kLeft, true, 255);
  EXPECT_EQ(BrickFolder::read(left / "duty_cycle_sp"), "0");
  set_motor(Motor::kRight, true, 255);
  EXPECT_EQ(take_command(right), "run-direct");
}

}  // namespace
}  // namespace echomap::hal
