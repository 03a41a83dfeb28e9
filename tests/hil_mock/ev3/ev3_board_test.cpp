// SPDX-License-Identifier: MIT
#include "hil_mock/ev3/ev3_board.hpp"

#include <csignal>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "hil_mock/world/mpu6050.hpp"
#include "hil_mock/world/noise.hpp"
#include "host/files/atomic_file.hpp"
#include "tests/support/thrown_text.hpp"

namespace echomap::ev3 {
namespace {

using testing::HasSubstr;

constexpr std::int64_t kMsNs = 1'000'000;
const std::string left = "tacho-motor/motor5/";
const std::string pan = "tacho-motor/motor3/";
const std::string range = "lego-sensor/sensor2/";

Ev3Options probe(RangeSensor sensor = RangeSensor::kUltrasonic) {
  return {{ECHOMAP_EV3_PROBE}, sensor, std::chrono::milliseconds(300)};
}

class Ev3BoardTest : public testing::Test {
 protected:
  explicit Ev3BoardTest(const Ev3Options& options = probe()) : board(options) {
    board.on_sent = [this](std::uint8_t byte) { sent += static_cast<char>(byte); };
  }
  void pass_ms(std::int64_t ms) { board.run_until(board.now_ns() + ms * kMsNs); }
  void say(const std::string& line) {
    const std::string all = line + "\n";
    board.receive(std::vector<std::uint8_t>(all.begin(), all.end()));
  }
  void write(const std::string& file, const std::string& text) {
    say("w " + file + " " + text);
    pass_ms(1);
  }
  std::string answer(const std::string& line) {
    sent.clear();
    say(line);
    pass_ms(2);
    return sent;
  }
  double left_duty() const { return board.motor_duty().left; }

  Ev3Board board;
  std::string sent;
};

class Ev3BoardWithNxtSonar : public Ev3BoardTest {
 protected:
  Ev3BoardWithNxtSonar() : Ev3BoardTest(probe(RangeSensor::kNxtSonar)) {}
};

TEST_F(Ev3BoardTest, BytesTakeEffectAndComeBackAtWholeMilliseconds) {
  board.run_until(10 * kMsNs + 300'000);
  say("t");
  board.run_until(11 * kMsNs - 1);
  EXPECT_EQ(sent, "");
  board.run_until(11 * kMsNs);
  EXPECT_EQ(sent, "");
  board.run_until(12 * kMsNs);
  EXPECT_EQ(sent, "11000\n");
}

TEST_F(Ev3BoardTest, BytesWakeAProgramThatSleepsLong) {
  say("s 500000");
  pass_ms(20);
  EXPECT_EQ(answer("t"), "21000\n");
}

TEST_F(Ev3BoardTest, TheSameBytesGiveTheSameRun) {
  const auto run = [] {
    Ev3Board other(probe());
    std::string said;
    other.on_sent = [&](std::uint8_t byte) {
      said += static_cast<char>(byte) + std::to_string(other.now_ns());
    };
    for (int i = 0; i < 50; ++i) {
      const std::vector<std::uint8_t> bytes{'t', '\n'};
      other.receive(bytes);
      other.run_until(other.now_ns() + 700'000);
    }
    return said;
  };
  EXPECT_EQ(run(), run());
}

TEST_F(Ev3BoardTest, RunsAMotorFromTheMillisecondInWhichItWasTold) {
  write(left + "duty_cycle_sp", "40");
  EXPECT_EQ(left_duty(), 0.0);
  write(left + "command", "run-direct");
  EXPECT_NEAR(left_duty(), 0.4, 1e-9);
  EXPECT_EQ(board.motor_duty().right, 0.0);
}

TEST_F(Ev3BoardTest, EndsWithWhatTheKernelWouldRefuse) {
  write(left + "duty_cycle_sp", "120");
  say("w " + left + "command run-direct");
  EXPECT_THAT(tests::thrown_text<std::runtime_error>([&] { pass_ms(1); }),
              HasSubstr("outB: duty_cycle_sp of 120"));
}

TEST_F(Ev3BoardTest, CountsEdgesIntoThePositionEveryTwoMilliseconds) {
  // Forward: 10, 11, 01, and one back.
  board.schedule_encoder_edge(runner::Wheel::kLeft, 100'000, true, false);
  board.schedule_encoder_edge(runner::Wheel::kLeft, 200'000, true, true);
  board.schedule_encoder_edge(runner::Wheel::kLeft, 300'000, false, true);
  board.schedule_encoder_edge(runner::Wheel::kLeft, 400'000, true, true);
  board.schedule_encoder_edge(runner::Wheel::kLeft, 2'400'000, false, true);
  board.run_until(2 * kMsNs);
  EXPECT_EQ(files::read_text_file(board.sysfs() / "class" / (left + "position")), "2\n");
  board.run_until(3 * kMsNs);
  EXPECT_EQ(files::read_text_file(board.sysfs() / "class" / (left + "position")), "2\n");
  board.run_until(4 * kMsNs);
  EXPECT_EQ(files::read_text_file(board.sysfs() / "class" / (left + "position")), "3\n");
}

TEST_F(Ev3BoardTest, MeasuresEvery50MillisecondsAndShowsARangeWhenItsEchoHasCome) {
  std::vector<std::int64_t> asked_ms;
  board.on_trigger = [&](std::int64_t at_ns) {
    asked_ms.push_back(at_ns / kMsNs);
    const std::int64_t rise_ns = at_ns + 460'000;
    board.schedule_echo(rise_ns, rise_ns + (asked_ms.size() == 1 ? 10 * kMsNs : 38 * kMsNs));
  };
  board.run_until(58 * kMsNs);
  EXPECT_EQ(answer("r " + range + "value0"), "2550\n");
  EXPECT_EQ(answer("r " + range + "value0"), "1716\n") << "10 ms of flight";
  board.run_until(145 * kMsNs);
  EXPECT_EQ(answer("r " + range + "value0"), "2550\n");
  EXPECT_THAT(asked_ms, testing::ElementsAre(50, 100));
}

TEST_F(Ev3BoardWithNxtSonar, TellsWholeCentimetresEvery100Milliseconds) {
  int asked = 0;
  board.on_trigger = [&](std::int64_t at_ns) {
    ++asked;
    board.schedule_echo(at_ns, at_ns + 10 * kMsNs);
  };
  board.run_until(250 * kMsNs);
  EXPECT_EQ(answer("r " + range + "value0"), "172\n");
  EXPECT_EQ(answer("r " + range + "driver_name"), "lego-nxt-us\n");
  EXPECT_EQ(asked, 2);
}

TEST_F(Ev3BoardTest, TouchAndGyroReachTheirFiles) {
  const world::RateGyro exact({0.0, 0.0, 0.0, 0.0},
                              world::NoiseStream(1, world::NoisePurpose::kGyro));
  world::Mpu6050 chip(exact);
  board.connect(chip);
  write("lego-sensor/sensor7/mode", "GYRO-RATE");
  for (int ms = 0; ms < 20; ++ms) {
    chip.step(1e-3, 0.5);
    pass_ms(1);
  }
  EXPECT_EQ(answer("r lego-sensor/sensor7/value0"), "-29\n") << "28.6 degrees/s to the left";
  board.set_bump(runner::Wheel::kRight, true);
  EXPECT_EQ(answer("r lego-sensor/sensor1/value0"), "1\n");
  EXPECT_EQ(answer("r lego-sensor/sensor4/value0"), "0\n");
}

TEST_F(Ev3BoardTest, AMicrosecondOfThePansPulseIsADegreeOfItsMotor) {
  write(pan + "position_sp", "270");
  write(pan + "speed_sp", "1000");
  write(pan + "command", "run-to-abs-pos");
  pass_ms(100);
  EXPECT_NEAR(board.pan_pulse_us(), 1600.0, 2.0);
  pass_ms(300);
  EXPECT_EQ(board.pan_pulse_us(), 1770.0);
  EXPECT_EQ(answer("r " + pan + "position"), "270\n");
}

TEST_F(Ev3BoardTest, MotorsRunOnWhenTheProgramDies) {
  write(left + "duty_cycle_sp", "40");
  write(left + "command", "run-direct");
  say("x");
  pass_ms(1000);
  EXPECT_NEAR(left_duty(), 0.4, 1e-9);
}

TEST_F(Ev3BoardTest, TimeGoesOnWithoutAProgramThatHangs) {
  write(left + "duty_cycle_sp", "40");
  write(left + "command", "run-direct");
  say("h");
  pass_ms(1000);
  EXPECT_EQ(board.now_ns(), 1002 * kMsNs);
  EXPECT_NEAR(left_duty(), 0.4, 1e-9);
}

TEST_F(Ev3BoardTest, AResetStopsTheMotorsAndStartsTheProgramAnew) {
  write(left + "duty_cycle_sp", "40");
  write(left + "command", "run-direct");
  say("h");
  pass_ms(10);
  const auto before = board.pid();
  board.reset();
  EXPECT_EQ(left_duty(), 0.0);
  EXPECT_FALSE(board.pid());
  pass_ms(301);
  EXPECT_NE(board.pid(), before);
  EXPECT_EQ(answer("t"), "314000\n");
}

TEST(Ev3Board, LeavesNothingBehind) {
  std::filesystem::path folder;
  {
    const Ev3Board board(probe());
    folder = board.sysfs().parent_path();
    EXPECT_TRUE(std::filesystem::exists(folder));
  }
  EXPECT_FALSE(std::filesystem::exists(folder));
}

TEST(Ev3Board, TellsOfAProgramThatDoesNotComeUp) {
  EXPECT_THAT(tests::thrown_text<std::runtime_error>([] { Ev3Board({{"false"}}); }),
              HasSubstr("false has ended with 1"));
}

TEST(Ev3Board, HasNoSparePins) {
  Ev3Board board(probe());
  EXPECT_THROW(board.set_aux_level(0, true), std::invalid_argument);
  EXPECT_THROW(board.set_aux_millivolts(0, 1.0), std::invalid_argument);
  EXPECT_FALSE(board.aux_output(0));
}

}  // namespace
}  // namespace echomap::ev3
