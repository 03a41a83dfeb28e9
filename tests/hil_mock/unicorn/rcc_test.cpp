// SPDX-License-Identifier: MIT
#include "hil_mock/unicorn/rcc.hpp"

#include <cstdint>

#include <gtest/gtest.h>

namespace echomap::unicorn {
namespace {

class Clocks : public ::testing::Test {
 protected:
  static constexpr std::uint32_t kCr = 0x00;
  static constexpr std::uint32_t kCfgr = 0x04;
  static constexpr std::uint32_t kApb2Enable = 0x18;
  static constexpr std::uint32_t kCsr = 0x24;
  static constexpr std::uint32_t kPllOn = 1U << 24;
  static constexpr std::uint32_t kPllReady = 1U << 25;
  static constexpr std::uint32_t kSwitchToPll = 2;
  static constexpr std::uint32_t kPinFlag = 1U << 26;
  static constexpr std::uint32_t kPowerOnFlag = 1U << 27;
  static constexpr std::uint32_t kIwdgFlag = 1U << 29;

  Clocks() { rcc.reset(); }

  EventQueue queue;
  Rcc rcc{queue};
};

TEST_F(Clocks, TheCoreIsNineTimesAsSlowUntilItRunsFromTheReadyPll) {
  EXPECT_EQ(rcc.cpu_cycle(), 9U);
  rcc.write(kCr, kPllOn);
  rcc.write(kCfgr, kSwitchToPll);
  EXPECT_EQ(rcc.cpu_cycle(), 9U) << "it is not ready";
  queue.skip_to(14'400);
  EXPECT_NE(rcc.read(kCr) & kPllReady, 0U);
  rcc.write(kCfgr, kSwitchToPll);
  EXPECT_EQ(rcc.cpu_cycle(), 1U);
  rcc.reset();
  EXPECT_EQ(rcc.cpu_cycle(), 9U);
}

TEST_F(Clocks, APeripheralHasNoneUntilItsBitIsSet) {
  EXPECT_TRUE(rcc.clocks(Rcc::Bus::kAlwaysOn, 0));
  EXPECT_FALSE(rcc.clocks(Rcc::Bus::kApb2, 3));
  rcc.write(kApb2Enable, 1U << 3);
  EXPECT_TRUE(rcc.clocks(Rcc::Bus::kApb2, 3));
  EXPECT_FALSE(rcc.clocks(Rcc::Bus::kApb1, 3));
}

TEST_F(Clocks, KeepsTheCausesOfResetsUntilTheProgramRemovesThem) {
  rcc.note_reset(ResetSource::kPowerOn);
  EXPECT_EQ(rcc.read(kCsr), kPowerOnFlag | kPinFlag);
  rcc.note_reset(ResetSource::kWatchdog);
  EXPECT_EQ(rcc.read(kCsr), kPowerOnFlag | kPinFlag | kIwdgFlag);
  rcc.write(kCsr, 1U << 24);
  EXPECT_EQ(rcc.read(kCsr), 0U);
  rcc.note_reset(ResetSource::kSoftware);
  EXPECT_EQ(rcc.read(kCsr), kPinFlag | 1U << 28);
}

}  // namespace
}  // namespace echomap::unicorn
