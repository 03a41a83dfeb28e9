// SPDX-License-Identifier: MIT
#include "hil_mock/ev3/tacho_motor.hpp"

#include <fstream>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/files/atomic_file.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/thrown_text.hpp"

namespace echomap::ev3 {
namespace {

using testing::HasSubstr;

class TachoMotorTest : public testing::Test {
 protected:
  void write(const std::string& name, const std::string& text) {
    std::fstream file(scratch / "motor4" / name, std::ios::in | std::ios::out);
    file << text << '\n';
  }
  std::string line(const std::string& name) {
    return files::read_text_file(scratch / "motor4" / name);
  }
  void command(const std::string& text) {
    write("command", text);
    motor.obey();
  }
  std::string refusal() {
    return tests::thrown_text<std::runtime_error>([&] { motor.obey(); });
  }

  tests::ScratchFolder scratch;
  TachoMotor motor{scratch / "motor4", "ev3-ports:outB", large_motor()};
};

TEST_F(TachoMotorTest, TurnsByItsDutyOnlyAfterRunDirect) {
  write("duty_cycle_sp", "50");
  motor.obey();
  EXPECT_EQ(motor.duty(), 0.0);
  command("run-direct");
  EXPECT_EQ(motor.duty(), 0.5);
  write("duty_cycle_sp", "-100");
  motor.obey();
  EXPECT_EQ(motor.duty(), -1.0) << "each write acts at once";
  EXPECT_EQ(line("state"), "running\n");
  command("stop");
  write("duty_cycle_sp", "30");
  motor.obey();
  EXPECT_EQ(motor.duty(), 0.0) << "until the next run-direct";
}

TEST_F(TachoMotorTest, StopFollowsItsAction) {
  command("run-direct");
  command("stop");
  EXPECT_FALSE(motor.brakes());
  write("stop_action", "brake");
  command("stop");
  EXPECT_TRUE(motor.brakes());
}

TEST_F(TachoMotorTest, RefusesADutyAboveAHundredPercent) {
  write("duty_cycle_sp", "101");
  write("command", "run-direct");
  EXPECT_THAT(refusal(), HasSubstr("ev3-ports:outB: duty_cycle_sp of 101 (EINVAL)"));
}

TEST_F(TachoMotorTest, RefusesAPositionWhileItRuns) {
  motor.show_position(90);
  write("position", "0");
  motor.show_position(90);
  EXPECT_EQ(line("position"), "0\n");
  motor.show_position(95);
  EXPECT_EQ(line("position"), "5\n") << "counted on from there";
  command("run-direct");
  write("position", "0");
  EXPECT_THAT(tests::thrown_text<std::runtime_error>([&] { motor.show_position(95); }),
              HasSubstr("(EBUSY)"));
}

TEST_F(TachoMotorTest, RefusesAStopThatWouldFollowARamp) {
  command("run-direct");
  write("ramp_down_sp", "500");
  write("command", "stop");
  EXPECT_THAT(refusal(), HasSubstr("ramp_down_sp"));
}

TEST_F(TachoMotorTest, RefusesWordsThatTheKernelDoesNotKnow) {
  write("command", "run-forever-and-ever");
  EXPECT_THAT(refusal(), HasSubstr("no command 'run-forever-and-ever'"));
  write("stop_action", "float");
  write("command", "stop");
  EXPECT_THAT(refusal(), HasSubstr("no stop_action 'float'"));
}

TEST_F(TachoMotorTest, ResetZeroesPositionAndSetPoints) {
  motor.show_position(720);
  write("duty_cycle_sp", "40");
  write("ramp_down_sp", "500");
  command("run-direct");
  command("reset");
  motor.show_position(721);
  EXPECT_EQ(motor.duty(), 0.0);
  EXPECT_EQ(line("position"), "1\n");
  EXPECT_EQ(line("duty_cycle_sp"), "0\n");
  EXPECT_EQ(line("ramp_down_sp"), "0\n");
}

TEST_F(TachoMotorTest, AnInversedOneTurnsAndCountsTheOtherWay) {
  write("polarity", "inversed");
  write("duty_cycle_sp", "25");
  command("run-direct");
  EXPECT_EQ(motor.duty(), -0.25);
  motor.show_position(-10);
  EXPECT_EQ(line("position"), "10\n");
}

TEST_F(TachoMotorTest, GoesToAPositionAtItsSpeedAndStaysThere) {
  write("position_sp", "-90");
  write("speed_sp", "300");
  command("run-to-abs-pos");
  motor.turn_freely(0.1);
  EXPECT_NEAR(motor.free_shaft_deg(), -30.0, 1e-9);
  motor.turn_freely(1.0);
  EXPECT_NEAR(motor.free_shaft_deg(), -90.0, 1e-9);
  write("speed_sp", "1051");
  write("command", "run-to-abs-pos");
  EXPECT_THAT(refusal(), HasSubstr("beyond max_speed"));
}

}  // namespace
}  // namespace echomap::ev3
