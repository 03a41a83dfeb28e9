// SPDX-License-Identifier: MIT
#include "host/apps/strategy_setup.hpp"

#include <gtest/gtest.h>

namespace echomap::apps {
namespace {

TEST(StrategySetup, TakesTheRobotFromItsProfile) {
  const RobotProfile profile = load_robot_profile("uno_2wd");
  const auto params = strategy_params(profile, 7);
  EXPECT_EQ(params.most_stops, 7U);
  EXPECT_EQ(params.robot_radius_m, profile.body_radius_m);
  EXPECT_EQ(params.pan_limit_rad, profile.pan_limit_rad);
  EXPECT_EQ(params.settle_s, profile.settle_s);
  EXPECT_EQ(pipeline_for(profile).snapshot().stops, 0U);
}

}  // namespace
}  // namespace echomap::apps
