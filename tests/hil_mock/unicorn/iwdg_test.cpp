// SPDX-License-Identifier: MIT
#include "hil_mock/unicorn/iwdg.hpp"

#include <cstdint>

#include <gtest/gtest.h>

namespace echomap::unicorn {
namespace {

class Watchdog : public ::testing::Test {
 protected:
  static constexpr std::uint32_t kKr = 0x0;
  static constexpr std::uint32_t kPr = 0x4;
  static constexpr std::uint32_t kRlr = 0x8;
  static constexpr std::uint32_t kKick = 0xAAAA;
  static constexpr std::uint32_t kUnlock = 0x5555;
  static constexpr std::uint32_t kStart = 0xCCCC;
  static constexpr std::uint64_t kMs = 72'000;

  Watchdog() {
    iwdg.reset();
    iwdg.on_timeout = [this] { ++timeouts; };
  }

  /// 100 of 40 kHz / 4: 10 ms.
  void start_with_10_ms() {
    iwdg.write(kKr, kUnlock);
    iwdg.write(kPr, 0);
    iwdg.write(kRlr, 99);
    iwdg.write(kKr, kStart);
  }

  EventQueue queue;
  Iwdg iwdg{queue};
  int timeouts = 0;
};

TEST_F(Watchdog, BitesWhenNobodyKicksIt) {
  start_with_10_ms();
  queue.skip_to(10 * kMs - 1);
  EXPECT_EQ(timeouts, 0);
  queue.skip_to(10 * kMs);
  EXPECT_EQ(timeouts, 1);
}

TEST_F(Watchdog, AKickGivesItsWholeTimeAgain) {
  start_with_10_ms();
  queue.skip_to(9 * kMs);
  iwdg.write(kKr, kKick);
  queue.skip_to(19 * kMs - 1);
  EXPECT_EQ(timeouts, 0);
  queue.skip_to(19 * kMs);
  EXPECT_EQ(timeouts, 1);
}

TEST_F(Watchdog, SleepsUntilItIsStarted) {
  iwdg.write(kKr, kKick);
  queue.skip_to(10'000 * kMs);
  EXPECT_EQ(timeouts, 0);
}

TEST_F(Watchdog, AWriteOfAnotherKeyLocksItsTimes) {
  start_with_10_ms();
  iwdg.write(kRlr, 4000);
  iwdg.write(kPr, 6);
  EXPECT_EQ(iwdg.read(kRlr), 99U);
  EXPECT_EQ(iwdg.read(kPr), 0U);
}

TEST_F(Watchdog, OnlyAResetStopsIt) {
  start_with_10_ms();
  iwdg.write(kKr, 0);
  iwdg.reset();
  queue.skip_to(10'000 * kMs);
  EXPECT_EQ(timeouts, 0);
  EXPECT_EQ(iwdg.read(kRlr), 0xFFFU);
}

}  // namespace
}  // namespace echomap::unicorn
