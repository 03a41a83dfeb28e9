// SPDX-License-Identifier: MIT
#include "hil_mock/unicorn/exti.hpp"

#include <cstdint>

#include <gtest/gtest.h>

namespace echomap::unicorn {
namespace {

constexpr std::uint32_t kImr = 0x00;
constexpr std::uint32_t kRtsr = 0x08;
constexpr std::uint32_t kFtsr = 0x0C;
constexpr std::uint32_t kPr = 0x14;
constexpr std::uint32_t kIser = 0xE000E100;

class ExtiTest : public testing::Test {
 protected:
  ExtiTest() {
    nvic.write(kIser, 0xFFFFFFFF);
    nvic.write(kIser + 4, 0xFFFFFFFF);
  }
  /// The interrupt line that is due; -1 for none.
  int due() const {
    const auto next = nvic.next({});
    return next ? int{*next} - Nvic::kFirstLine : -1;
  }

  Nvic nvic;
  Exti exti{nvic};
};

TEST_F(ExtiTest, LatchesTheEdgeItIsToldToAndInterruptsUntilItIsCleared) {
  exti.write(kImr, 1U << 3);
  exti.write(kFtsr, 1U << 3);
  exti.take_edge(3, true);
  EXPECT_EQ(due(), -1);
  exti.take_edge(3, false);
  exti.take_edge(3, true);
  EXPECT_EQ(exti.read(kPr), 1U << 3);
  EXPECT_EQ(due(), 9);
  exti.write(kPr, 1U << 3);
  EXPECT_EQ(exti.read(kPr), 0U);
  exti.write(kFtsr, 0);
  exti.write(kRtsr, 1U << 3);
  exti.take_edge(3, false);
  EXPECT_EQ(exti.read(kPr), 0U);
  exti.take_edge(3, true);
  EXPECT_EQ(exti.read(kPr), 1U << 3);
}

/// RM0008, table 63.
TEST_F(ExtiTest, SharesInterruptsAboveLineFour) {
  struct {
    std::uint8_t line;
    int interrupt;
  } const rows[] = {{0, 6}, {4, 10}, {5, 23}, {9, 23}, {10, 40}, {15, 40}};
  exti.write(kImr, 0xFFFF);
  exti.write(kFtsr, 0xFFFF);
  for (const auto& row : rows) {
    Nvic fresh;
    fresh.write(kIser, 0xFFFFFFFF);
    fresh.write(kIser + 4, 0xFFFFFFFF);
    nvic = fresh;
    exti.take_edge(row.line, false);
    EXPECT_EQ(due(), row.interrupt) << int{row.line};
    exti.write(kPr, 0xFFFF);
  }
}

TEST_F(ExtiTest, KeepsWhatIsNotEnabledToItself) {
  exti.write(kFtsr, 0xFFFF);
  exti.take_edge(7, false);
  EXPECT_EQ(due(), -1);
  EXPECT_EQ(exti.read(kPr), 1U << 7);
  exti.write(kImr, 1U << 7);
  EXPECT_EQ(due(), 23) << "it was latched";
  exti.reset();
  EXPECT_EQ(exti.read(kImr), 0U);
  EXPECT_EQ(exti.read(kPr), 0U);
}

}  // namespace
}  // namespace echomap::unicorn
