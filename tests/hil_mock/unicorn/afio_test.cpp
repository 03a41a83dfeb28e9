// SPDX-License-Identifier: MIT
#include "hil_mock/unicorn/afio.hpp"

#include <cstdint>

#include <gtest/gtest.h>

namespace echomap::unicorn {
namespace {

constexpr std::uint32_t kMapr = 0x04;

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

TEST(Afio, SaysOfWhichPortALineIs) {
  constexpr std::uint32_t kExticr3 = 0x10;
  Afio afio;
  EXPECT_EQ(afio.port_of_line(11), 0U);
  afio.write(kExticr3, 0x1000);
  EXPECT_EQ(afio.read(kExticr3), 0x1000U);
  EXPECT_EQ(afio.port_of_line(11), 1U);
  EXPECT_EQ(afio.port_of_line(10), 0U);
  EXPECT_EQ(afio.port_of_line(7), 0U);
  afio.reset();
  EXPECT_EQ(afio.port_of_line(11), 0U);
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
