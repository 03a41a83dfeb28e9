// SPDX-License-Identifier: MIT
#include "hil_mock/unicorn/exti.hpp"

#include <cstdint>

#include <gtest/gtest.h>

namespace echomap::unicorn {
namespace {

constexpr std::uint32_t kMapr = 0x04;
constexpr std::uint32_t kExticr4 = 0x14;
constexpr std::uint32_t kImr = 0x00;
constexpr std::uint32_t kRtsr = 0x08;
constexpr std::uint32_t kFtsr = 0x0C;
constexpr std::uint32_t kPr = 0x14;
constexpr std::uint8_t kPortA = 0;
constexpr std::uint8_t kPortB = 1;
constexpr std::uint32_t kPin12 = 1U << 12;

/// Line 12 listens to port B, both edges.
class LineTwelve : public ::testing::Test {
 protected:
  LineTwelve() {
    afio.write(kExticr4, 1);
    exti.write(kImr, kPin12);
    exti.write(kRtsr, kPin12);
    exti.write(kFtsr, kPin12);
    nvic.write(0xE000E104, 1U << 8);
  }

  bool interrupts() const { return nvic.next({}).has_value(); }

  Afio afio;
  Nvic nvic;
  Exti exti{afio, nvic};
};

TEST_F(LineTwelve, InterruptsAtAnEdgeUntilItsFlagIsCleared) {
  exti.on_pin(kPortB, 12, true);
  EXPECT_TRUE(interrupts());
  exti.write(kPr, kPin12);
  nvic.write(0xE000E284, 1U << 8);
  EXPECT_FALSE(interrupts());
  EXPECT_EQ(exti.read(kPr), 0U);
}

TEST_F(LineTwelve, HearsThePortThatAfioNamesOnly) {
  exti.on_pin(kPortA, 12, true);
  EXPECT_FALSE(interrupts());
  afio.write(kExticr4, 0);
  exti.on_pin(kPortA, 12, true);
  EXPECT_TRUE(interrupts());
}

TEST_F(LineTwelve, HearsTheEdgesThatItIsToldOnly) {
  exti.write(kRtsr, 0);
  exti.on_pin(kPortB, 12, true);
  EXPECT_FALSE(interrupts());
  exti.on_pin(kPortB, 12, false);
  EXPECT_TRUE(interrupts());
}

TEST_F(LineTwelve, AMaskedEdgeWaitsInItsFlag) {
  exti.write(kImr, 0);
  exti.on_pin(kPortB, 12, true);
  EXPECT_FALSE(interrupts());
  EXPECT_EQ(exti.read(kPr), kPin12);
  exti.write(kImr, kPin12);
  EXPECT_TRUE(interrupts());
}

/// Pins that JTAG has, by SWJ_CFG: RM0008, table 36.
TEST(Afio, LeavesToJtagWhatTheProgramDoesNotTake) {
  constexpr std::uint32_t kA15 = 1U << 15;
  constexpr std::uint32_t kB3 = 1U << 3;
  constexpr std::uint32_t kB4 = 1U << 4;
  struct {
    std::uint32_t swj_cfg, of_a, of_b;
  } const rows[] = {{0, kA15, kB3 | kB4}, {1, kA15, kB3}, {2, 0, 0}, {4, 0, 0}};
  for (const auto& row : rows) {
    Afio afio;
    afio.write(kMapr, row.swj_cfg << 24);
    EXPECT_EQ(afio.jtag_pins_of_a(), row.of_a) << row.swj_cfg;
    EXPECT_EQ(afio.jtag_pins_of_b(), row.of_b) << row.swj_cfg;
  }
}

TEST(Afio, MovesTim2AndTellsEachChange) {
  Afio afio;
  int calls = 0;
  afio.on_remap = [&] { ++calls; };
  EXPECT_FALSE(afio.tim2_is_on_a15_and_b3());
  afio.write(kMapr, 1U << 8 | 2U << 24);
  EXPECT_TRUE(afio.tim2_is_on_a15_and_b3());
  EXPECT_EQ(afio.read(kMapr), 1U << 8) << "nobody can read SWJ_CFG";
  afio.reset();
  EXPECT_FALSE(afio.tim2_is_on_a15_and_b3());
  EXPECT_NE(afio.jtag_pins_of_a(), 0U);
  EXPECT_EQ(calls, 2);
}

}  // namespace
}  // namespace echomap::unicorn
