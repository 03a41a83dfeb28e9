// SPDX-License-Identifier: MIT
#include "hil_mock/unicorn/adc.hpp"

#include <cstdint>

#include <gtest/gtest.h>

namespace echomap::unicorn {
namespace {

class Converter : public ::testing::Test {
 protected:
  static constexpr std::uint32_t kSr = 0x00;
  static constexpr std::uint32_t kCr2 = 0x08;
  static constexpr std::uint32_t kSqr3 = 0x34;
  static constexpr std::uint32_t kDr = 0x4C;
  static constexpr std::uint32_t kDone = 2;
  static constexpr std::uint32_t kOn = 1;
  static constexpr std::uint32_t kStart = 1U << 22;

  Converter() {
    adc.reset();
    adc.set_input(3, 1234);
    adc.write(kSqr3, 3);
  }

  EventQueue queue;
  Adc adc{queue};
};

TEST_F(Converter, ConvertsItsChannelInSixtyEightOfItsCycles) {
  adc.write(kCr2, kOn | kStart);
  queue.skip_to(407);
  EXPECT_EQ(adc.read(kSr) & kDone, 0U);
  queue.skip_to(408);
  EXPECT_EQ(adc.read(kSr) & kDone, kDone);
  EXPECT_EQ(adc.read(kDr), 1234U);
  EXPECT_EQ(adc.read(kSr) & kDone, 0U) << "reading the value clears the flag";
}

TEST_F(Converter, DoesNothingWhileSwitchedOff) {
  adc.write(kCr2, kStart);
  queue.skip_to(1000);
  EXPECT_EQ(adc.read(kSr) & kDone, 0U);
}

TEST_F(Converter, AResetCallsAConversionOff) {
  adc.write(kCr2, kOn | kStart);
  adc.reset();
  queue.skip_to(1000);
  EXPECT_EQ(adc.read(kSr) & kDone, 0U);
}

}  // namespace
}  // namespace echomap::unicorn
