// SPDX-License-Identifier: MIT
#include "host/exploration/explorer.hpp"

#include <gtest/gtest.h>

namespace echomap::exploration {
namespace {

TEST(FinishReason, HasTheNamesOfTheSummary) {
  EXPECT_STREQ(name_of(FinishReason::kStopLimit), "stop-limit");
  EXPECT_STREQ(name_of(FinishReason::kNoNewGround), "no-new-ground");
  EXPECT_STREQ(name_of(FinishReason::kNowhereToGo), "nowhere-to-go");
}

}  // namespace
}  // namespace echomap::exploration
