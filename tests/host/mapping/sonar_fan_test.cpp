// SPDX-License-Identifier: MIT
#include "host/mapping/sonar_fan.hpp"

#include <gtest/gtest.h>

namespace echomap::mapping {
namespace {

constexpr double kCellM = 0.05;
const models::SonarCone kCone;
const FanRays kRays(kCone.params().max_range_m, kCellM);
const SonarView kAhead{{0.0, 0.0}, {{0.0, 2.0}}};

TEST(SonarFan, HoldsPointsInTheConeOnly) {
  const SonarFan fan(kAhead, kCone, kRays);
  EXPECT_TRUE(fan.place({1.0, 0.2}));
  EXPECT_TRUE(fan.place({1.0, -0.2}));
  EXPECT_FALSE(fan.place({1.0, 0.4}));
  EXPECT_FALSE(fan.place({-1.0, 0.0}));
  EXPECT_FALSE(fan.place({3.2, 0.0}));
}

TEST(SonarFan, MissesLittleBeforeTheEchoAndAllBehind) {
  const SonarFan fan(kAhead, kCone, kRays);
  EXPECT_NEAR(fan.miss_chance(*fan.place({1.0, 0.0})), 0.1, 1e-6);
  EXPECT_EQ(fan.miss_chance(*fan.place({2.5, 0.0})), 1.0);
}

TEST(SonarFan, BelievesTheBeamThatSaysMost) {
  const SonarView two{{0.0, 0.0}, {{0.0, 1.0}, {0.1, 2.0}}};
  const SonarFan fan(two, kCone, kRays);
  EXPECT_LT(fan.miss_chance(*fan.place({1.5, 0.1})), 0.3);
}

TEST(SonarFan, DoesNotGetThroughAWall) {
  SonarFan fan(kAhead, kCone, kRays);
  fan.look([](const Eigen::Vector2d& point_m) {
    return point_m.x() > 1.0 && point_m.x() < 1.05 ? 0.9 : 0.0;
  });
  EXPECT_NEAR(fan.reached(*fan.place({0.9, 0.0}), 0.0), 1.0, 1e-6);
  EXPECT_NEAR(fan.reached(*fan.place({1.5, 0.0}), 0.0), 0.1, 1e-6);
  EXPECT_NEAR(fan.reached(*fan.place({1.04, 0.0}), kCellM), 1.0, 1e-6);
}

}  // namespace
}  // namespace echomap::mapping
