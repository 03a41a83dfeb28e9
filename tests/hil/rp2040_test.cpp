// SPDX-License-Identifier: MIT
/// What only the Pico has to show: its second boot stage, its watchdog, its PIO's counting.
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <unistd.h>
#include <vector>

#include <gtest/gtest.h>

#include "hil_mock/rp2040/rp2040_board.hpp"
#include "tests/hil/release_images.hpp"
#include "tests/hil/robot_session.hpp"
#include "tests/hil/turning_wheel.hpp"
#include "tests/support/simulated_time.hpp"

namespace echomap::tests {
namespace {

using rp2040::PicoLine;
using rp2040::Rp2040Board;
using runner::Wheel;

constexpr const char* kImage = "echomap-pico";

class PicoBoot : public ::testing::Test {
 protected:
  ~PicoBoot() override { std::filesystem::remove(copy_); }

  /// The image with this byte of its flash inverted.
  std::filesystem::path spoilt_at(std::size_t at) {
    const std::filesystem::path folder = std::filesystem::path(ECHOMAP_BINARY_DIR) / "firmware";
    std::ifstream image(folder / "echomap-pico.bin", std::ios::binary);
    std::vector<char> bytes{std::istreambuf_iterator<char>(image), {}};
    bytes.at(at) = static_cast<char>(~bytes.at(at));
    std::ofstream(copy_, std::ios::binary).write(bytes.data(), std::ssize(bytes));
    return copy_;
  }

  const std::filesystem::path copy_ = std::filesystem::temp_directory_path() /
                                      ("echomap-pico-" + std::to_string(::getpid()) + ".bin");
};

TEST_F(PicoBoot, RomRefusesASecondStageWithOneWrongByte) {
  constexpr std::size_t kLastOfChecked = 251;
  EXPECT_THROW(Rp2040Board(spoilt_at(kLastOfChecked), PicoLine::kUart), std::runtime_error);
}

TEST_F(PicoBoot, TimerIsSetToMicrosecondsOfTheCrystal) {
  constexpr std::uint32_t kWatchdogTick = 0x4005'802C;
  constexpr std::uint32_t kTimerRawLow = 0x4005'4028;
  Rp2040Board board(release_image(kImage), PicoLine::kUart);
  board.run_until(10 * kMs);
  EXPECT_EQ(board.peek(kWatchdogTick) & 0x3FFU, 0x200U | 12U) << "12 MHz, and enabled";
  const std::uint32_t before = board.peek(kTimerRawLow);
  board.run_until(board.now_ns() + 10 * kMs);
  EXPECT_NEAR(double(board.peek(kTimerRawLow) - before), 10'000.0, 1.0);
}

/// What a program hangs in: with interrupts open its warning resets the chip, else the watchdog.
enum Hang : std::uint32_t {
  kInterruptsOpen = 0xE7FE'B662,    // cpsie i; b .
  kInterruptsLocked = 0xE7FE'B672,  // cpsid i; b .
};

class PicoWatchdog : public ::testing::TestWithParam<Hang> {};

INSTANTIATE_TEST_SUITE_P(Hangs,
                         PicoWatchdog,
                         ::testing::Values(kInterruptsOpen, kInterruptsLocked));

TEST_P(PicoWatchdog, ResetsAHangingProgramOnceAndLetsItGoOn) {
  constexpr std::uint32_t kTrap = 0x2003'0000;  // Behind program and stack.
  RobotSession robot{release_image(kImage)};
  ASSERT_TRUE(robot.connect());
  auto& board = dynamic_cast<Rp2040Board&>(robot.board());
  board.poke(kTrap, GetParam());
  board.jump(kTrap);
  robot.run_ms(300);
  EXPECT_EQ(board.resets(), 1U);
  robot.run_ms(4'000);
  EXPECT_EQ(board.resets(), 1U);
  const auto hello = robot.connect(4712);
  ASSERT_TRUE(hello);
  EXPECT_EQ(hello->reset_cause, protocol::kResetWatchdog);
}

class PicoEncoders : public ::testing::TestWithParam<int> {};

INSTANTIATE_TEST_SUITE_P(JitterPercent, PicoEncoders, ::testing::Values(0, 20, 40));

TEST_P(PicoEncoders, CountEveryOfTwoHundredThousandEdgesASecondOfBothWheels) {
  constexpr double kEdgesPerS = 200'000.0;
  constexpr std::int64_t kStepMs = 5;
  constexpr int kSteps = 20;
  RobotSession robot{release_image(kImage)};
  ASSERT_TRUE(robot.connect());
  const double jitter = GetParam() * 1e-2;
  TurningWheel left(robot.board(), Wheel::kLeft, {jitter, 1});
  TurningWheel right(robot.board(), Wheel::kRight, {jitter, 2});
  for (int step = 0; step < kSteps; ++step) {
    left.turn(step % 4 == 3 ? -kEdgesPerS : kEdgesPerS, kStepMs * kMs);
    right.turn(step % 3 == 0 ? kEdgesPerS : -kEdgesPerS, kStepMs * kMs);
    robot.run_ms(kStepMs + 1);
  }
  robot.run_ms(50);
  const auto odometry = robot.last<protocol::Odometry>();
  ASSERT_TRUE(odometry);
  EXPECT_EQ(left.count(), 10'000);
  EXPECT_EQ(odometry->left_ticks, left.count());
  EXPECT_EQ(odometry->right_ticks, right.count());
  robot.run_ms(1'100);
  const auto health = robot.last<protocol::Health>();
  ASSERT_TRUE(health);
  EXPECT_EQ(health->encoder_errors, 0);
}

}  // namespace
}  // namespace echomap::tests
