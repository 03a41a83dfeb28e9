// SPDX-License-Identifier: MIT
#include "host/models/sonar_cone.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/host/models/echo.hpp"

namespace echomap::models {
namespace {

const SonarCone kCone;
const double kEdgeRad = SonarConeParams().beam_half_angle_rad;

TEST(SonarCone, HearsLessAtItsEdgeAndNothingBeyond) {
  EXPECT_DOUBLE_EQ(kCone.weight(0.0), 1.0);
  EXPECT_DOUBLE_EQ(kCone.weight(kEdgeRad), SonarConeParams().edge_weight);
  EXPECT_DOUBLE_EQ(kCone.weight(-kEdgeRad), SonarConeParams().edge_weight);
  EXPECT_DOUBLE_EQ(kCone.weight(1.01 * kEdgeRad), 0.0);
}

TEST(SonarCone, CallsFloorFreeBeforeTheEchoTheSurerTheNearerToTheAxis) {
  EXPECT_LT(kCone.evidence(kEcho, {0.5, 0.0}), kCone.evidence(kEcho, {0.5, kEdgeRad}));
  EXPECT_LT(kCone.evidence(kEcho, {0.5, kEdgeRad}), 0.0);
}

TEST(SonarCone, TrustsSilenceLessThanAnEcho) {
  EXPECT_LT(kCone.evidence(kEcho, {0.5, 0.0}), kCone.evidence({}, {0.5, 0.0}));
  EXPECT_LT(kCone.evidence({}, {0.5, 0.0}), 0.0);
}

TEST(SonarCone, SaysNothingBehindTheEcho) {
  EXPECT_EQ(kCone.evidence(kEcho, {1.11, 0.0}), 0.0);
  EXPECT_EQ(kCone.evidence(kEcho, {2.0, 0.0}), 0.0);
}

TEST(SonarCone, SharesOneEchoOverItsArc) {
  EXPECT_GT(kCone.evidence(kEcho, {1.0, 0.0}), 0.0);
  EXPECT_GT(kCone.evidence(kEcho, {1.0, 0.0}), kCone.evidence({2.0}, {2.0, 0.0}));
  EXPECT_LE(kCone.evidence({0.05}, {0.05, 0.0}), SonarConeParams().cell_evidence);
}

TEST(SonarCone, ReachesToItsArcOrToItsEndOfRange) {
  EXPECT_DOUBLE_EQ(kCone.reach_m(kEcho), 1.1);
  EXPECT_DOUBLE_EQ(kCone.reach_m({}), 3.0);
}

TEST(SonarCone, HearsEchoesFromFartherThanSilenceSpeaksOf) {
  SonarConeParams params;
  params.max_range_m = 5.0;
  const SonarCone far(params);
  EXPECT_LT(far.evidence({}, {2.9, 0.0}), 0.0);
  EXPECT_EQ(far.evidence({}, {3.1, 0.0}), 0.0);
  EXPECT_LT(far.evidence({4.0}, {3.1, 0.0}), 0.0);
}

TEST(SonarCone, RefusesParametersWithoutSense) {
  SonarConeParams params;
  params.silent_chance = 1.0;
  EXPECT_THROW(SonarCone{params}, std::invalid_argument);
  params = {};
  params.beam_half_angle_rad = 1.0;
  EXPECT_THROW(SonarCone{params}, std::invalid_argument);
}

}  // namespace
}  // namespace echomap::models
