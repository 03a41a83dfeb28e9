// SPDX-License-Identifier: MIT
#include "host/models/gaussian_patch.hpp"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/host/models/echo.hpp"

namespace echomap::models {
namespace {

const GaussianPatch kPatch;

TEST(GaussianPatch, IsHighestWhereTheEchoWouldLieOnTheAxis) {
  EXPECT_DOUBLE_EQ(kPatch.evidence(kEcho, {1.0, 0.0}), 1.0);
}

TEST(GaussianPatch, FallsOffAlikeAheadAndAside) {
  const double expected = std::exp(-0.5);
  EXPECT_NEAR(kPatch.evidence(kEcho, {1.05, 0.0}), expected, 1e-12);
  EXPECT_NEAR(
      kPatch.evidence(kEcho, {std::hypot(1.0, 0.05), std::atan2(0.05, 1.0)}), expected, 1e-12);
}

TEST(GaussianPatch, EndsAtItsRadius) {
  EXPECT_GT(kPatch.evidence(kEcho, {1.12, 0.0}), 0.0);
  EXPECT_EQ(kPatch.evidence(kEcho, {1.13, 0.0}), 0.0);
}

TEST(GaussianPatch, NeverSpeaksOfFreeFloorOrSilence) {
  EXPECT_EQ(kPatch.evidence(kEcho, {0.5, 0.0}), 0.0);
  EXPECT_EQ(kPatch.evidence({}, {0.5, 0.0}), 0.0);
}

TEST(GaussianPatch, DrawsABumpAcrossTheWayForward) {
  const auto line = bumper_line(0.1, 0.2);
  EXPECT_DOUBLE_EQ(line.length_m(), 0.2);
  EXPECT_DOUBLE_EQ(line.from_m.x(), line.to_m.x());
}

TEST(GaussianPatch, RefusesParametersWithoutSense) {
  EXPECT_THROW(GaussianPatch({0.0, 0.1}), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::models
