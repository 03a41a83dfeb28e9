// SPDX-License-Identifier: MIT
#include "host/datasets/rising_stamp.hpp"

#include <gtest/gtest.h>

namespace echomap::datasets {
namespace {

TEST(RisingStamp, AStampThatDoesNotRiseIsNone) {
  RisingStamp stamps;
  EXPECT_EQ(stamps.accept(1.0), 1.0);
  EXPECT_EQ(stamps.accept(1.0), std::nullopt);
  EXPECT_EQ(stamps.accept(0.5), std::nullopt);
  EXPECT_EQ(stamps.accept(1.25), 1.25);
}

}  // namespace
}  // namespace echomap::datasets
