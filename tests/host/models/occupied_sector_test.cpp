// SPDX-License-Identifier: MIT
#include "host/models/occupied_sector.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"
#include "tests/host/models/echo.hpp"

namespace echomap::models {
namespace {

const OccupiedSector kSector;

TEST(OccupiedSector, CallsAllBeforeTheEchoFree) {
  EXPECT_LT(kSector.evidence(kEcho, {0.3, 0.0}), 0.0);
  EXPECT_LT(kSector.evidence(kEcho, {0.94, geometry::radians(14.0)}), 0.0);
}

TEST(OccupiedSector, CallsAThicknessAroundTheEchoOccupied) {
  EXPECT_GT(kSector.evidence(kEcho, {0.96, 0.0}), 0.0);
  EXPECT_GT(kSector.evidence(kEcho, {1.04, geometry::radians(-14.0)}), 0.0);
  EXPECT_EQ(kSector.evidence(kEcho, {1.06, 0.0}), 0.0);
}

// As line 8 is printed in the paper, the obstacle would stand here.
TEST(OccupiedSector, PutsNoObstacleAtTheEndOfRange) {
  EXPECT_EQ(kSector.evidence(kEcho, {OccupiedSectorParams().max_range_m, 0.0}), 0.0);
}

TEST(OccupiedSector, SaysNothingOutsideOfTheBeam) {
  EXPECT_EQ(kSector.evidence(kEcho, {0.5, geometry::radians(16.0)}), 0.0);
}

TEST(OccupiedSector, CallsTheWholeBeamFreeWhereNothingAnswers) {
  EXPECT_LT(kSector.evidence({}, {2.9, 0.0}), 0.0);
  EXPECT_EQ(kSector.evidence({}, {3.1, 0.0}), 0.0);
}

TEST(OccupiedSector, ReachesBeyondTheEchoByHalfTheThickness) {
  EXPECT_DOUBLE_EQ(kSector.reach_m(kEcho), 1.05);
  EXPECT_DOUBLE_EQ(kSector.reach_m({}), 3.0);
}

TEST(OccupiedSector, RefusesParametersWithoutSense) {
  OccupiedSectorParams params;
  params.free_log_odds = 0.1;
  EXPECT_THROW(OccupiedSector{params}, std::invalid_argument);
}

}  // namespace
}  // namespace echomap::models
