// SPDX-License-Identifier: MIT
#include "firmware/drivers/wheel_encoders.hpp"

#include <random>

#include <gtest/gtest.h>

#include "firmware/hal/quadrature_table.hpp"
#include "tests/firmware/simulated_wheel.hpp"

namespace echomap::drivers {
namespace {

using tests::quadrature_levels;

std::uint8_t levels(std::int32_t left, std::int32_t right) {
  return static_cast<std::uint8_t>(quadrature_levels(left) | (quadrature_levels(right) << 2));
}

//  before   after: 00   A=1  B=1  11
TEST(QuadratureStep, IsTheTableOfX4Decoding) {
  constexpr int kX = hal::kIllegalStep;
  constexpr int kExpected[4][4] = {
      {0, 1, -1, kX},  // 00
      {-1, 0, kX, 1},  // A
      {1, kX, 0, -1},  // B
      {kX, -1, 1, 0},  // A and B
  };
  for (std::uint8_t before = 0; before < 4; ++before) {
    for (std::uint8_t after = 0; after < 4; ++after) {
      EXPECT_EQ(hal::quadrature_step(before, after), kExpected[before][after]) << +before << +after;
    }
  }
}

TEST(WheelEncoders, CountsARandomWalkOfBothWheels) {
  WheelEncoders encoders;
  encoders.start(levels(0, 0));
  std::mt19937 generator(2);
  std::int32_t left = 0;
  std::int32_t right = 0;
  for (int i = 0; i < 200000; ++i) {
    const auto bits = static_cast<std::uint32_t>(generator());
    left += (bits & 1U) != 0 ? ((bits & 6U) != 0 ? 1 : -1) : 0;
    right += (bits & 8U) != 0 ? ((bits & 0x30U) != 0 ? -1 : 1) : 0;
    encoders.on_pins(levels(left, right));
    if (i % 100 == 0) {
      encoders.fold();
    }
  }
  EXPECT_EQ(encoders.counts().left, static_cast<std::int16_t>(left));
  EXPECT_EQ(encoders.counts().right, static_cast<std::int16_t>(right));
  EXPECT_EQ(encoders.errors().left, 0);
  EXPECT_EQ(encoders.errors().right, 0);
}

TEST(WheelEncoders, CountsJumpsOfBothPinsAsErrorsAndNotAsWay) {
  WheelEncoders encoders;
  encoders.start(0b0000);
  encoders.on_pins(0b0011);
  encoders.on_pins(0b1111);
  encoders.on_pins(0b1100);
  encoders.on_pins(0b0000);
  EXPECT_EQ(encoders.errors().left, 2);
  EXPECT_EQ(encoders.errors().right, 2);
  encoders.fold();
  encoders.on_pins(0b0011);
  EXPECT_EQ(encoders.errors().left, 3);
  EXPECT_EQ(encoders.errors().right, 2);
  EXPECT_EQ(encoders.counts().left, 0);
  EXPECT_EQ(encoders.counts().right, 0);
}

TEST(WheelEncoders, StartTakesTheLevelsThatItFinds) {
  WheelEncoders encoders;
  encoders.start(0b1111);
  encoders.on_pins(0b1111);
  encoders.on_pins(0b1110);
  EXPECT_EQ(encoders.errors().left, 0);
  EXPECT_EQ(encoders.errors().right, 0);
  EXPECT_EQ(encoders.counts().left, 1);
}

TEST(WheelEncoders, InversionKeepsPastCounts) {
  WheelEncoders encoders;
  encoders.start(levels(0, 0));
  for (int i = 1; i <= 10; ++i) {
    encoders.on_pins(levels(i, i));
  }
  encoders.invert(true, false);
  for (int i = 11; i <= 14; ++i) {
    encoders.on_pins(levels(i, i));
  }
  EXPECT_EQ(encoders.counts().left, 6);
  EXPECT_EQ(encoders.counts().right, 14);
}

}  // namespace
}  // namespace echomap::drivers
