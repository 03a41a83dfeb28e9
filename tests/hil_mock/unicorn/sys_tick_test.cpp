// SPDX-License-Identifier: MIT
#include "hil_mock/unicorn/sys_tick.hpp"

#include <cstdint>

#include <gtest/gtest.h>

namespace echomap::unicorn {
namespace {

constexpr std::uint32_t kCtrl = 0x0;
constexpr std::uint32_t kLoad = 0x4;
constexpr std::uint32_t kVal = 0x8;
constexpr std::uint32_t kRunAndInterrupt = 7;
constexpr std::uint32_t kRun = 5;

/// Rounds of 100 cycles.
class Tick : public ::testing::Test {
 protected:
  Tick() {
    tick.reset();
    tick.write(kLoad, 99);
  }

  EventQueue queue;
  Nvic nvic;
  SysTick tick{queue, nvic};
};

TEST_F(Tick, CountsDownAndBeginsAgain) {
  tick.write(kCtrl, kRun);
  EXPECT_EQ(tick.read(kVal), 99U);
  queue.skip_to(30);
  EXPECT_EQ(tick.read(kVal), 69U);
  queue.skip_to(199);
  EXPECT_EQ(tick.read(kVal), 0U);
  queue.skip_to(200);
  EXPECT_EQ(tick.read(kVal), 99U);
}

TEST_F(Tick, InterruptsAtTheEndOfARound) {
  tick.write(kCtrl, kRunAndInterrupt);
  queue.skip_to(99);
  EXPECT_FALSE(nvic.sys_tick_pends());
  queue.skip_to(100);
  EXPECT_TRUE(nvic.sys_tick_pends());
}

TEST_F(Tick, DoesNotInterruptUnlessItIsTold) {
  tick.write(kCtrl, kRun);
  queue.skip_to(1000);
  EXPECT_FALSE(nvic.sys_tick_pends());
}

TEST_F(Tick, AWriteOfTheCountBeginsTheRoundAgain) {
  tick.write(kCtrl, kRunAndInterrupt);
  queue.skip_to(60);
  tick.write(kVal, 1);
  queue.skip_to(159);
  EXPECT_FALSE(nvic.sys_tick_pends());
  queue.skip_to(160);
  EXPECT_TRUE(nvic.sys_tick_pends());
}

TEST_F(Tick, AResetStopsIt) {
  tick.write(kCtrl, kRunAndInterrupt);
  tick.reset();
  queue.skip_to(1000);
  EXPECT_FALSE(nvic.sys_tick_pends());
}

}  // namespace
}  // namespace echomap::unicorn
