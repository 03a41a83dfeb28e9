// SPDX-License-Identifier: MIT
#include "host/exploration/explorer.hpp"

#include <gtest/gtest.h>

namespace echomap::exploration {
namespace {

TEST(FinishReason, HasTheNamesOfTheSummary) {
  EXPECT_STREQ(name_of(FinishReason::kComplete), "complete");
  EXPECT_STREQ(name_of(FinishReason::kStopLimit), "stop-limit");
  EXPECT_STREQ(name_of(FinishReason::kNoNewGround), "no-new-ground");
  EXPECT_STREQ(name_of(FinishReason::kNowhereToGo), "nowhere-to-go");
  EXPECT_STREQ(name_of(FinishReason::kWaypointsMissed), "waypoints-missed");
  EXPECT_STREQ(name_of(FinishReason::kNotBack), "not-back");
  EXPECT_STREQ(name_of(FinishReason::kSonarSilent), "sonar-silent");
  EXPECT_STREQ(name_of(FinishReason::kSonarStuck), "sonar-stuck");
  EXPECT_STREQ(name_of(FinishReason::kWheelFault), "wheel-fault");
  EXPECT_STREQ(name_of(FinishReason::kLost), "lost");
}

}  // namespace
}  // namespace echomap::exploration
