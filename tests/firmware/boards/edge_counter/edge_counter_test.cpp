// SPDX-License-Identifier: MIT
#include "firmware/boards/edge_counter/edge_counter.hpp"

#include <random>

#include <gtest/gtest.h>

#include "firmware/boards/edge_counter/quadrature_table.hpp"
#include "firmware/hal/encoders.hpp"
#include "tests/firmware/simulated_wheel.hpp"

namespace echomap::boards {
namespace {

using tests::quadrature_levels;

std::uint8_t levels(std::int32_t left, std::int32_t right) {
  return static_cast<std::uint8_t>(quadrature_levels(left) | (quadrature_levels(right) << 2));
}

//  before   after: 00   A=1  B=1  11
TEST(QuadratureStep, IsTheTableOfX4Decoding) {
  constexpr int kX = kIllegalStep;
  constexpr int kExpected[4][4] = {
      {0, 1, -1, kX},  // 00
      {-1, 0, kX, 1},  // A
      {1, kX, 0, -1},  // B
      {kX, -1, 1, 0},  // A and B
  };
  for (std::uint8_t before = 0; before < 4; ++before) {
    for (std::uint8_t after = 0; after < 4; ++after) {
      EXPECT_EQ(quadrature_step(before, after), kExpected[before][after]) << +before << +after;
    }
  }
}

TEST(EdgeCounter, CountsARandomWalkOfBothWheels) {
  start_edge_count(levels(0, 0));
  std::mt19937 generator(2);
  std::int32_t left = 0;
  std::int32_t right = 0;
  for (int i = 0; i < 200000; ++i) {
    const auto bits = static_cast<std::uint32_t>(generator());
    left += (bits & 1U) != 0 ? ((bits & 6U) != 0 ? 1 : -1) : 0;
    right += (bits & 8U) != 0 ? ((bits & 0x30U) != 0 ? -1 : 1) : 0;
    count_edges(levels(left, right));
    if (i % 100 == 0) {
      fold_edges();
    }
  }
  const hal::EncoderReading reading = hal::read_encoders();
  EXPECT_EQ(reading.left, static_cast<std::int16_t>(left));
  EXPECT_EQ(reading.right, static_cast<std::int16_t>(right));
  EXPECT_EQ(hal::lost_encoder_steps().left, 0);
  EXPECT_EQ(hal::lost_encoder_steps().right, 0);
}

TEST(EdgeCounter, CountsJumpsOfBothPinsAsLostAndNotAsWay) {
  start_edge_count(0b0000);
  count_edges(0b0011);
  count_edges(0b1111);
  count_edges(0b1100);
  count_edges(0b0000);
  EXPECT_EQ(hal::lost_encoder_steps().left, 2);
  EXPECT_EQ(hal::lost_encoder_steps().right, 2);
  fold_edges();
  count_edges(0b0011);
  EXPECT_EQ(hal::lost_encoder_steps().left, 3);
  EXPECT_EQ(hal::lost_encoder_steps().right, 2);
  EXPECT_EQ(hal::read_encoders().left, 0);
  EXPECT_EQ(hal::read_encoders().right, 0);
}

TEST(EdgeCounter, StartTakesTheLevelsThatItFindsAndForgetsWhatWasCounted) {
  start_edge_count(0b0000);
  count_edges(0b0001);
  fold_edges();
  start_edge_count(0b1111);
  EXPECT_EQ(hal::read_encoders().left, 0);
  count_edges(0b1111);
  count_edges(0b1110);
  EXPECT_EQ(hal::lost_encoder_steps().left, 0);
  EXPECT_EQ(hal::lost_encoder_steps().right, 0);
  EXPECT_EQ(hal::read_encoders().left, 1);
}

}  // namespace
}  // namespace echomap::boards
