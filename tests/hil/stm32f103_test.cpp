// SPDX-License-Identifier: MIT
/// What only the STM32F103 has to show: the AVR boards have other watchdogs, clocks and memories.
#include <array>
#include <cstdint>
#include <cstdio>
#include <span>

#include <gtest/gtest.h>

#include "hil_mock/unicorn/unicorn_board.hpp"
#include "tests/hil/release_images.hpp"
#include "tests/hil/robot_session.hpp"

namespace echomap::tests {
namespace {

using protocol::CommandStatus;

/// Behind the program, where these tests put their own.
constexpr std::uint32_t kTrap = 0x08006000;

class Stm32 : public ::testing::Test {
 protected:
  unicorn::Stm32Chip& chip() { return dynamic_cast<unicorn::UnicornBoard&>(robot.board()).chip(); }

  void write_code(std::uint32_t address, std::span<const std::uint16_t> code) {
    chip().core().write_memory(
        address, {reinterpret_cast<const std::uint8_t*>(code.data()), code.size_bytes()});
  }

  /// Both wheels at full duty, under a command that is renewed.
  void drive() {
    ASSERT_TRUE(robot.connect());
    ASSERT_EQ(robot.command(protocol::Arm{0, 1}), CommandStatus::kAccepted);
    robot.each_ms = [this] {
      if (robot.board().now_ns() / 1'000'000 % 50 == 0) {
        robot.send(protocol::DriveSetpoint{2000, 2000, 200});
      }
    };
    robot.run_ms(300);
    ASSERT_FALSE(off());
  }

  bool off() {
    const runner::MotorDuty duty = robot.board().motor_duty();
    return duty.left == 0.0 && duty.right == 0.0;
  }

  std::uint32_t count_of(runner::Wheel wheel) {
    constexpr std::uint32_t kCnt = 0x24;
    return (wheel == runner::Wheel::kLeft ? chip().tim2() : chip().tim4()).read(kCnt);
  }

  /// A leads B: an edge of A, and back again without being looked at.
  int counts_of_an_edge(runner::Wheel wheel) {
    const std::uint32_t before = count_of(wheel);
    robot.board().schedule_encoder_edge(wheel, robot.board().now_ns() + 100'000, true, false);
    robot.run_ms(1);
    const std::uint32_t after = count_of(wheel);
    robot.board().schedule_encoder_edge(wheel, robot.board().now_ns() + 100'000, false, false);
    robot.run_ms(1);
    return static_cast<std::int16_t>(after - before);
  }

  /// Motors off by the watchdog's warning, then the reset by the watchdog itself.
  void expect_warning_and_reset() {
    const std::int64_t start_ns = robot.board().now_ns();
    ASSERT_TRUE(robot.run_until([this] { return off(); }, 400));
    const double off_ms = double(robot.board().now_ns() - start_ns) * 1e-6;
    EXPECT_EQ(chip().resets(), 0U);
    ASSERT_TRUE(robot.run_until([this] { return chip().resets() == 1; }, 400));
    std::printf("hang: PWM off after %.1f ms\n", off_ms);
    EXPECT_LE(off_ms, 58.5);
    EXPECT_TRUE(off());
  }

  RobotSession robot{release_image("echomap-stm32f103")};
};

TEST_F(Stm32, WarningStrikesThroughALockThatNobodyOpens) {
  drive();
  constexpr std::array<std::uint16_t, 5> kLockAndHang{
      0xB662, 0x2010, 0xF380, 0x8811, 0xE7FE};  // cpsie i; movs r0, #0x10; msr basepri, r0; b .
  write_code(kTrap, kLockAndHang);
  chip().core().jump_to(kTrap);
  expect_warning_and_reset();
}

TEST_F(Stm32, WarningStrikesIntoAHungInterrupt) {
  drive();
  constexpr std::array<std::uint16_t, 1> kHang{0xE7FE};  // b .
  write_code(kTrap, kHang);
  constexpr std::uint32_t kVectorOfTick = 0x0800003C;
  constexpr std::array<std::uint16_t, 2> kTrapVector{(kTrap & 0xFFFF) | 1, kTrap >> 16};
  write_code(kVectorOfTick, kTrapVector);
  expect_warning_and_reset();
}

TEST_F(Stm32, BootIdIsAnotherOneAfterEachOf600PowerCuts) {
  robot.run_ms(20);
  std::uint16_t before = robot.last<protocol::HelloReply>()->boot_id;
  for (int i = 0; i < 600; ++i) {  // More than one page of the flash has entries.
    robot.forget_heard();
    robot.chip().cut_power();
    robot.run_ms(40);
    ASSERT_TRUE(robot.last<protocol::HelloReply>()) << i;
    const std::uint16_t boot_id = robot.last<protocol::HelloReply>()->boot_id;
    ASSERT_NE(boot_id, before) << i;
    before = boot_id;
  }
}

/// The emulated chip has 32 kB: the program would crash where it looked for more.
TEST(Stm32Flash, PowerUpsAreCountedInTheLastPageOfTheSmallestPart) {
  constexpr std::uint32_t kLastPage = unicorn::FlashWriter::kDataBytes - 1024;
  constexpr std::uint64_t kStartCycles = unicorn::kClockHz / 50;
  unicorn::Stm32Chip chip(release_image("echomap-stm32f103"));
  for (std::uint32_t start = 0; start < 3; ++start) {
    chip.run_to(chip.cycle() + kStartCycles);
    EXPECT_EQ(chip.flash().read_data(kLastPage + 2 * start, 2), start + 1);
    EXPECT_EQ(chip.flash().read_data(kLastPage + 2 * start + 2, 2), 0xFFFFU);
    chip.reset(unicorn::ResetSource::kPowerOn);
  }
}

TEST_F(Stm32, MotorsStandWhileTheChipIsInReset) {
  drive();
  robot.each_ms = nullptr;
  robot.chip().pull_reset_pin();
  EXPECT_TRUE(off());
  robot.run_ms(50);
  EXPECT_TRUE(off());
}

TEST_F(Stm32, LeftEncoderAndLeftMotorHangOnWhatAfioRemaps) {
  drive();
  ASSERT_GT(robot.board().motor_duty().left, 0.0);
  ASSERT_EQ(counts_of_an_edge(runner::Wheel::kLeft), 1);
  ASSERT_EQ(counts_of_an_edge(runner::Wheel::kRight), 1);
  // movw r0, #4; movt r0, #0x4001 (AFIO_MAPR); movs r1, #0; str r1, [r0]; b .
  constexpr std::array<std::uint16_t, 7> kUndoRemap{
      0xF240, 0x0004, 0xF2C4, 0x0001, 0x2100, 0x6001, 0xE7FE};
  write_code(kTrap, kUndoRemap);
  chip().core().jump_to(kTrap);
  robot.run_ms(1);
  EXPECT_EQ(counts_of_an_edge(runner::Wheel::kLeft), 0) << "TIM2_CH1 is on A0";
  EXPECT_EQ(counts_of_an_edge(runner::Wheel::kRight), 1);
  EXPECT_LT(robot.board().motor_duty().left, 0.0) << "B4 is JTAG's";
  EXPECT_GT(robot.board().motor_duty().right, 0.0);
}

TEST_F(Stm32, FullDutyHasNoGap) {
  ASSERT_TRUE(robot.connect());
  const protocol::ConfigureSafety no_guard{0, 0, 0, 0, 0};  // it would stop wheels that stand
  ASSERT_EQ(robot.command(no_guard), CommandStatus::kAccepted);
  ASSERT_EQ(robot.command(protocol::Arm{0, 1}), CommandStatus::kAccepted);
  robot.send(protocol::DriveSetpoint{3000, -3000, 500});
  robot.run_ms(450);  // The wheels stand, so the controllers go to their ends.
  EXPECT_EQ(robot.board().motor_duty().left, 1.0);
  EXPECT_EQ(robot.board().motor_duty().right, -1.0);
}

}  // namespace
}  // namespace echomap::tests
