// SPDX-License-Identifier: MIT
#include "host/localization/usable_reading.hpp"

#include <limits>

#include <gtest/gtest.h>

namespace echomap::localization {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

TEST(UsableReading, IsARangeOrSilenceFromAPlaceThatIsANumber) {
  EXPECT_TRUE(is_usable({{0.1, 0.0, 1.0}, 0.0}));
  EXPECT_TRUE(is_usable({{}, std::nullopt}));
  EXPECT_FALSE(is_usable({{}, -0.01}));
  EXPECT_FALSE(is_usable({{}, kNaN}));
  EXPECT_FALSE(is_usable({{}, std::numeric_limits<double>::infinity()}));
  EXPECT_FALSE(is_usable({{0.0, kNaN, 0.0}, 1.0}));
  EXPECT_FALSE(is_usable({{0.0, 0.0, kNaN}, std::nullopt}));
}

}  // namespace
}  // namespace echomap::localization
