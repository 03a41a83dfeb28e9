// SPDX-License-Identifier: MIT
#include "firmware/drivers/wheel_encoders.hpp"

#include <gtest/gtest.h>

#include "firmware/boards/edge_counter/edge_counter.hpp"
#include "tests/firmware/simulated_wheel.hpp"

namespace echomap::drivers {
namespace {

/// Turns both wheels forward from count `from` to count `to`.
void turn(std::int32_t from, std::int32_t to) {
  for (std::int32_t count = from + 1; count <= to; ++count) {
    const unsigned levels = tests::quadrature_levels(count);
    boards::count_edges(static_cast<std::uint8_t>(levels | levels << 2));
    boards::fold_edges();
  }
}

TEST(WheelEncoders, InversionKeepsPastCounts) {
  boards::start_edge_count(0);
  WheelEncoders encoders;
  turn(0, 10);
  encoders.invert(true, false);
  EXPECT_EQ(encoders.counts().left, 10);
  turn(10, 14);
  EXPECT_EQ(encoders.counts().left, 6);
  EXPECT_EQ(encoders.counts().right, 14);
  encoders.invert(false, true);
  turn(14, 15);
  EXPECT_EQ(encoders.counts().left, 7);
  EXPECT_EQ(encoders.counts().right, 13);
}

TEST(WheelEncoders, CountsGoOnBeyondSixteenBits) {
  boards::start_edge_count(0);
  WheelEncoders encoders;
  encoders.invert(false, true);
  turn(0, 40000);
  EXPECT_EQ(encoders.counts().left, static_cast<std::int16_t>(40000));
  EXPECT_EQ(encoders.counts().right, static_cast<std::int16_t>(-40000));
}

}  // namespace
}  // namespace echomap::drivers
