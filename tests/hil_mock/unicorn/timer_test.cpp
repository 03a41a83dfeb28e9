// SPDX-License-Identifier: MIT
#include "hil_mock/unicorn/timer.hpp"

#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

namespace echomap::unicorn {
namespace {

/// Counts every tenth cycle from 0 to 99.
class TenCycleTimer : public ::testing::Test {
 protected:
  static constexpr std::uint32_t kCr1 = 0x00;
  static constexpr std::uint32_t kDier = 0x0C;
  static constexpr std::uint32_t kSr = 0x10;
  static constexpr std::uint32_t kEgr = 0x14;
  static constexpr std::uint32_t kCcmr1 = 0x18;
  static constexpr std::uint32_t kCcer = 0x20;
  static constexpr std::uint32_t kCnt = 0x24;
  static constexpr std::uint32_t kPsc = 0x28;
  static constexpr std::uint32_t kArr = 0x2C;
  static constexpr std::uint32_t kCcr1 = 0x34;
  static constexpr std::uint32_t kCcr2 = 0x38;
  static constexpr std::uint8_t kLine = 30;

  TenCycleTimer() {
    timer.reset();
    timer.write(kPsc, 9);
    timer.write(kArr, 99);
    timer.write(kEgr, 1);
    timer.write(kSr, 0);
    timer.write(kCr1, 1);
    nvic.write(0xE000E100, 1U << kLine);
  }

  bool interrupts() const { return nvic.next({}).has_value(); }

  EventQueue queue;
  Nvic nvic;
  Timer timer{queue, nvic, {kLine, kLine}};
};

TEST_F(TenCycleTimer, CountsWithItsPrescalerAndBeginsAgain) {
  queue.skip_to(259);
  EXPECT_EQ(timer.read(kCnt), 25U);
  queue.skip_to(1000);
  EXPECT_EQ(timer.read(kCnt), 0U);
}

TEST_F(TenCycleTimer, TakesAPrescalerAtTheUpdateOnly) {
  timer.write(kPsc, 0);
  queue.skip_to(100);
  EXPECT_EQ(timer.read(kCnt), 10U);
  timer.write(kEgr, 1);
  queue.skip_to(150);
  EXPECT_EQ(timer.read(kCnt), 50U);
}

TEST_F(TenCycleTimer, InterruptsAtItsUpdateUnlessSetBackBefore) {
  timer.write(kDier, 1);
  queue.skip_to(990);
  timer.write(kCnt, 0);
  queue.skip_to(1980);
  EXPECT_FALSE(interrupts());
  queue.skip_to(1990);
  EXPECT_TRUE(interrupts());
}

TEST_F(TenCycleTimer, AnInterruptThatIsEnabledLaterDoesNotShiftTheCount) {
  queue.skip_to(255);
  timer.write(kDier, 1);
  queue.skip_to(260);
  EXPECT_EQ(timer.read(kCnt), 26U);
}

TEST_F(TenCycleTimer, CapturesBothEdgesOfOneInputAtTheirCycle) {
  timer.write(kCcmr1, 0x0201);  // Channel 1 and 2 from input 1.
  timer.write(kCcer, 0x31);     // Channel 2 on the falling edge.
  queue.at(123, [this] { timer.set_input(1, true); });
  queue.at(777, [this] { timer.set_input(1, false); });
  queue.skip_to(900);
  EXPECT_EQ(timer.read(kSr), 6U);
  EXPECT_EQ(timer.read(kCcr1), 12U);
  EXPECT_EQ(timer.read(kSr), 4U) << "reading a capture clears its flag";
  EXPECT_EQ(timer.read(kCcr2), 77U);
}

TEST_F(TenCycleTimer, PwmIsTheShareOfCountsBelowTheCompareValue) {
  timer.write(kCcmr1, 0x6060);
  timer.write(kCcer, 0x11);
  timer.write(kCcr1, 25);
  timer.write(kCcr2, 255);
  EXPECT_DOUBLE_EQ(timer.output(1).high_share(), 0.25);
  EXPECT_DOUBLE_EQ(timer.output(2).high_share(), 1.0);
  EXPECT_EQ(timer.pulse_cycles(1), 250U);
  timer.write(kCcer, 0);
  EXPECT_DOUBLE_EQ(timer.output(2).high_share(), 0.0);
}

TEST_F(TenCycleTimer, PwmIsInvertedByPolarityOrByItsSecondMode) {
  constexpr double kPeriodUs = 1000.0 / 72.0;
  timer.write(kCcr1, 25);
  timer.write(kCcmr1, 0x60);
  timer.write(kCcer, 0x1);
  EXPECT_EQ(timer.output(1), world::pulses(0.25, kPeriodUs));
  timer.write(kCcer, 0x3);
  EXPECT_EQ(timer.output(1), world::inverted_pulses(0.25, kPeriodUs));
  timer.write(kCcmr1, 0x70);
  EXPECT_EQ(timer.output(1), world::pulses(0.25, kPeriodUs));
  timer.write(kCcer, 0x1);
  EXPECT_EQ(timer.output(1), world::inverted_pulses(0.25, kPeriodUs));
  timer.write(kCcmr1, 0x50);
  EXPECT_EQ(timer.output(1), world::level(true)) << "forced active";
  timer.write(kCcmr1, 0x40);
  EXPECT_EQ(timer.output(1), world::level(false)) << "forced inactive";
}

/// With PWM on channel 1 whose compares are preloaded, and no interrupt.
class PreloadedTimer : public TenCycleTimer {
 protected:
  static constexpr std::uint32_t kPwm = 0x60;
  static constexpr std::uint32_t kPreloadedPwm = 0x68;

  PreloadedTimer() {
    timer.write(kCcmr1, kPwm);
    timer.write(kCcer, 0x1);
    timer.write(kCcr1, 25);
    timer.write(kCcmr1, kPreloadedPwm);
    timer.on_preload_taken = [this] { taken_at.push_back(queue.now()); };
  }

  std::vector<std::uint64_t> taken_at;
};

TEST_F(PreloadedTimer, TakesACompareAtTheUpdateOnlyAndTellsIt) {
  queue.skip_to(500);
  timer.write(kCcr1, 50);
  EXPECT_EQ(timer.read(kCcr1), 50U) << "reads back what comes next";
  queue.skip_to(999);
  EXPECT_EQ(timer.pulse_cycles(1), 250U);
  EXPECT_DOUBLE_EQ(timer.output(1).high_share(), 0.25);
  queue.skip_to(1000);
  EXPECT_EQ(timer.pulse_cycles(1), 500U);
  EXPECT_DOUBLE_EQ(timer.output(1).high_share(), 0.5);
  queue.skip_to(5000);
  EXPECT_EQ(taken_at, std::vector<std::uint64_t>{1000});
  EXPECT_EQ(timer.read(kSr), 0U) << "the flag comes with its interrupt only";
}

TEST_F(PreloadedTimer, TakesTheLastOfTheComparesOfARound) {
  timer.write(kCcr1, 90);
  timer.write(kCcr1, 10);
  queue.skip_to(1000);
  EXPECT_EQ(timer.pulse_cycles(1), 100U);
}

TEST_F(PreloadedTimer, TakesACompareAtAnUpdateByTheProgram) {
  timer.write(kCcr1, 50);
  timer.write(kEgr, 1);
  EXPECT_EQ(timer.pulse_cycles(1), 500U);
}

TEST_F(PreloadedTimer, TakesACompareWithAnInterruptAsWithoutOne) {
  timer.write(kDier, 1);
  timer.write(kCcr1, 50);
  queue.skip_to(999);
  EXPECT_EQ(timer.pulse_cycles(1), 250U);
  EXPECT_FALSE(interrupts());
  queue.skip_to(1000);
  EXPECT_EQ(timer.pulse_cycles(1), 500U);
  EXPECT_TRUE(interrupts());
}

TEST_F(PreloadedTimer, KeepsACompareWhileItIsStopped) {
  queue.skip_to(500);
  timer.write(kCcr1, 50);
  timer.write(kCr1, 0);
  queue.skip_to(5000);
  EXPECT_TRUE(taken_at.empty());
  timer.write(kCr1, 1);
  EXPECT_EQ(timer.pulse_cycles(1), 250U);
  queue.skip_to(5500);
  EXPECT_EQ(timer.pulse_cycles(1), 500U);
}

TEST_F(PreloadedTimer, TakesACompareAtOnceWithoutItsPreload) {
  timer.write(kCcr1, 50);
  timer.write(kCcmr1, kPwm);
  EXPECT_EQ(timer.pulse_cycles(1), 500U);
  timer.write(kCcr1, 75);
  EXPECT_EQ(timer.pulse_cycles(1), 750U);
  EXPECT_TRUE(taken_at.empty());
}

TEST_F(PreloadedTimer, EndsItsPulsesBehindTheOneUnderWayWithAZero) {
  queue.skip_to(100);
  timer.write(kCcr1, 0);
  queue.skip_to(249);
  EXPECT_EQ(timer.pulse_cycles(1), 250U);
  queue.skip_to(250);
  EXPECT_EQ(timer.pulse_cycles(1), 0U);
  EXPECT_DOUBLE_EQ(timer.output(1).high_share(), 0.0);
  timer.write(kCcr1, 50);
  queue.skip_to(1000);
  EXPECT_EQ(timer.pulse_cycles(1), 500U);
}

TEST_F(PreloadedTimer, TellsNothingOfWhatAnotherChannelCaptures) {
  timer.write(kCcmr1, 0x0200 | kPreloadedPwm);  // Channel 2 from input 1.
  timer.write(kCcer, 0x11);
  timer.set_input(1, true);
  timer.write(kCcr1, 25);
  queue.skip_to(5000);
  EXPECT_TRUE(taken_at.empty());
}

constexpr std::uint32_t kSmcr = 0x08;
constexpr std::uint32_t kBdtr = 0x44;

/// As an encoder of both inputs.
class EncoderTimer : public TenCycleTimer {
 protected:
  EncoderTimer() {
    timer.write(kArr, 0xFFFF);
    timer.write(kCcmr1, 0x0101);
    timer.write(kSmcr, 3);
  }

  /// A full period of the pins is four edges.
  void turn_forward() {
    for (const bool high : {true, false}) {
      timer.set_input(1, high);
      timer.set_input(2, high);
    }
  }
  void turn_back() {
    for (const bool high : {true, false}) {
      timer.set_input(2, high);
      timer.set_input(1, high);
    }
  }
};

TEST_F(EncoderTimer, CountsEveryEdgeUpWhereTheFirstInputLeadsAndNotTheClock) {
  turn_forward();
  turn_forward();
  queue.skip_to(1000);
  EXPECT_EQ(timer.read(kCnt), 8U);
  turn_back();
  EXPECT_EQ(timer.read(kCnt), 4U);
}

TEST_F(EncoderTimer, CountsBackFromZeroToItsReload) {
  turn_back();
  EXPECT_EQ(timer.read(kCnt), 0xFFFCU);
  turn_forward();
  EXPECT_EQ(timer.read(kCnt), 0U);
}

TEST_F(EncoderTimer, DoesNotCountWhileItIsStopped) {
  timer.write(kCr1, 0);
  turn_forward();
  EXPECT_EQ(timer.read(kCnt), 0U);
}

/// TIM1: BDTR.MOE, and a line of its own for captures.
TEST(MainTimer, HasNoOutputsBeforeItsMainEnableAndALineForCaptures) {
  constexpr std::uint8_t kUpdateLine = 25;
  constexpr std::uint8_t kCaptureLine = 27;
  EventQueue queue;
  Nvic nvic;
  Timer timer(queue, nvic, {kUpdateLine, kCaptureLine, true});
  timer.reset();
  timer.write(0x1C, 0x6000);  // Channel 4: PWM.
  timer.write(0x18, 0x01);    // Channel 1 from input 1.
  timer.write(0x20, 0x1001);
  timer.write(0x40, 0x8000);
  timer.write(0x00, 1);
  EXPECT_DOUBLE_EQ(timer.output(4).high_share(), 0.0);
  timer.write(kBdtr, 1U << 15);
  EXPECT_DOUBLE_EQ(timer.output(4).high_share(), 0.5);
  nvic.write(0xE000E100, 1U << kUpdateLine);
  timer.write(0x0C, 2);
  timer.set_input(1, true);
  EXPECT_FALSE(nvic.next({}).has_value()) << "a capture is no update";
  nvic.write(0xE000E100, 1U << kCaptureLine);
  EXPECT_TRUE(nvic.next({}).has_value());
}

}  // namespace
}  // namespace echomap::unicorn
