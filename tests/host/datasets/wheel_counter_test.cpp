// SPDX-License-Identifier: MIT
#include "host/datasets/wheel_counter.hpp"

#include <gtest/gtest.h>

namespace echomap::datasets {
namespace {

TEST(WheelCounter, TheFirstReadingIsWhereItStarts) {
  WheelCounter counter;
  EXPECT_EQ(counter.increment(20795.0), 0.0);
  EXPECT_EQ(counter.increment(20800.0), 5.0);
  EXPECT_EQ(counter.increment(20790.0), -10.0);
}

}  // namespace
}  // namespace echomap::datasets
