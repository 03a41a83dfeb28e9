// SPDX-License-Identifier: MIT
#include "hil_mock/unicorn/nvic.hpp"

#include <cstdint>

#include <gtest/gtest.h>

namespace echomap::unicorn {
namespace {

constexpr std::uint32_t kSetEnable = 0xE000E100;
constexpr std::uint32_t kClearPending = 0xE000E280;
constexpr std::uint32_t kPriorities = 0xE000E400;
constexpr std::uint32_t kSystemPriorities3 = 0xE000ED20;

/// Lines 0 and 1 are enabled, line 0 at priority 0x20, line 1 at 0x10.
class TwoLines : public ::testing::Test {
 protected:
  TwoLines() {
    nvic.write(kSetEnable, 3);
    nvic.write(kPriorities, 0x1020);
  }

  static constexpr Exception kLine0 = Nvic::kFirstLine;
  static constexpr Exception kLine1 = Nvic::kFirstLine + 1;
  Nvic nvic;
};

TEST_F(TwoLines, TheMoreUrgentGoesFirst) {
  nvic.set_line(0, true);
  nvic.set_line(1, true);
  EXPECT_EQ(nvic.next({}), kLine1);
  nvic.enter(kLine1);
  EXPECT_EQ(nvic.next({}), std::nullopt) << "line 0 may not interrupt it";
}

TEST_F(TwoLines, OfTheSamePriorityTheLowerNumberGoesFirstAndNoneInterrupts) {
  nvic.write(kPriorities, 0x1010);
  nvic.write(kSystemPriorities3, 0x10000000);
  nvic.set_line(1, true);
  nvic.set_line(0, true);
  nvic.pend_sys_tick();
  EXPECT_EQ(nvic.next({}), Nvic::kSysTick);
  nvic.enter(Nvic::kSysTick);
  EXPECT_EQ(nvic.next({}), std::nullopt);
}

TEST_F(TwoLines, BasepriHoldsBackItsOwnPriorityAndAllBelow) {
  nvic.set_line(0, true);
  EXPECT_EQ(nvic.next({false, 0x20}), std::nullopt);
  EXPECT_EQ(nvic.next({false, 0x30}), kLine0);
  EXPECT_FALSE(nvic.wakes(0x20));
}

TEST_F(TwoLines, PrimaskHoldsBackAllButLetsThemWake) {
  nvic.set_line(0, true);
  EXPECT_EQ(nvic.next({true, 0}), std::nullopt);
  EXPECT_TRUE(nvic.wakes(0));
}

TEST_F(TwoLines, ALineThatStaysHighIsServedAgain) {
  nvic.set_line(0, true);
  nvic.enter(kLine0);
  nvic.leave();
  EXPECT_EQ(nvic.next({}), kLine0);
}

TEST_F(TwoLines, APulseIsServedOnce) {
  nvic.set_line(0, true);
  nvic.set_line(0, false);
  EXPECT_EQ(nvic.next({}), kLine0);
  nvic.enter(kLine0);
  nvic.leave();
  EXPECT_EQ(nvic.next({}), std::nullopt);
}

TEST_F(TwoLines, ClearingALineThatIsHighDoesNothing) {
  nvic.set_line(0, true);
  nvic.write(kClearPending, 1);
  EXPECT_EQ(nvic.next({}), kLine0);
  nvic.set_line(0, false);
  nvic.write(kClearPending, 1);
  EXPECT_EQ(nvic.next({}), std::nullopt);
}

TEST(Nvic, ADisabledLineWaitsForItsEnabling) {
  Nvic nvic;
  nvic.set_line(40, true);
  EXPECT_EQ(nvic.next({}), std::nullopt);
  nvic.write(kSetEnable + 4, 1U << 8);
  EXPECT_EQ(nvic.next({}), Nvic::kFirstLine + 40);
}

}  // namespace
}  // namespace echomap::unicorn
