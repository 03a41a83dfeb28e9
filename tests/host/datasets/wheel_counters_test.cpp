// SPDX-License-Identifier: MIT
#include "host/datasets/wheel_counters.hpp"

#include <gtest/gtest.h>

namespace echomap::datasets {
namespace {

TEST(WheelCounters, StartAtTheFirstReadings) {
  WheelCounters wheels(0.5, 0.3);
  const WheelIncrement first = wheels.increment(1.0, 20795.0, -3.0);
  EXPECT_EQ(first.left_m, 0.0);
  EXPECT_EQ(first.right_m, 0.0);
  EXPECT_EQ(first.track_m, 0.3);
  EXPECT_EQ(first.stamp_s, 1.0);
}

TEST(WheelCounters, CountOnFromTheLastReadings) {
  WheelCounters wheels(0.5, 0.3);
  wheels.increment({}, 20795.0, -3.0);
  const WheelIncrement ahead = wheels.increment({}, 20800.0, -3.0);
  EXPECT_EQ(ahead.left_m, 2.5);
  EXPECT_EQ(ahead.right_m, 0.0);
  const WheelIncrement back = wheels.increment({}, 20790.0, 5.0);
  EXPECT_EQ(back.left_m, -5.0);
  EXPECT_EQ(back.right_m, 4.0);
}

}  // namespace
}  // namespace echomap::datasets
