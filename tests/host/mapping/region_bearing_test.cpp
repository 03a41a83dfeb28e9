// SPDX-License-Identifier: MIT
#include "host/mapping/region_bearing.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"
#include "host/sensors/range_scan.hpp"
#include "tests/host/mapping/default_params.hpp"

namespace echomap::mapping {
namespace {

using geometry::radians;

/// Looks every 4 degrees; those up to `half_deg` off `at_deg` are answered from a metre.
std::vector<sensors::Beam> looks_at(double at_deg, double half_deg) {
  std::vector<sensors::Beam> looks;
  for (double deg = -180.0; deg < 180.0; deg += 4.0) {
    looks.push_back({radians(deg), std::nullopt});
    const double off_rad =
        std::abs(geometry::angle_between(looks.back().bearing_rad, radians(at_deg)));
    if (off_rad <= radians(half_deg)) {
      looks.back().range_m = range_off_foot_m(1.0, off_rad, kSurfaceParams);
    }
  }
  return looks;
}

double bearing_deg(const std::vector<sensors::Beam>& looks, double near_deg) {
  return geometry::degrees(
      likely_bearing_rad(looks, radians(near_deg), radians(16.0), 1.0, kSurfaceParams));
}

TEST(RangeOffFoot, GrowsOnlyBeyondTheBeam) {
  EXPECT_DOUBLE_EQ(range_off_foot_m(1.0, 0.5 * kSurfaceParams.beam_half_angle_rad, kSurfaceParams),
                   1.0);
  EXPECT_DOUBLE_EQ(
      range_off_foot_m(1.0, kSurfaceParams.beam_half_angle_rad + radians(60.0), kSurfaceParams),
      1.0 / std::cos(radians(60.0)));
}

TEST(LikelyBearing, IsTheMiddleOfWhatWasHeard) {
  EXPECT_NEAR(bearing_deg(looks_at(20.0, 26.0), 14.0), 20.0, 1.0);
  EXPECT_NEAR(bearing_deg(looks_at(20.0, 14.0), 25.0), 20.0, 1.0);
}

TEST(LikelyBearing, LiesAcrossTheCutOfTheCircle) {
  const double off_deg = bearing_deg(looks_at(178.0, 26.0), -176.0) - 178.0;
  EXPECT_NEAR(std::remainder(off_deg, 360.0), 0.0, 1.0);
}

TEST(LikelyBearing, IsNotPulledAsideByWhatStandsBeforeIt) {
  auto looks = looks_at(0.0, 26.0);
  for (sensors::Beam& look : looks) {
    if (look.bearing_rad > radians(9.0) && look.bearing_rad < radians(60.0)) {
      look.range_m = 0.5;
    }
  }
  const double middle_deg = -8.0;
  EXPECT_GT(bearing_deg(looks, middle_deg), middle_deg + 2.0);
}

TEST(LikelyBearing, IsTheMiddleOfWhatIsCutOnBothSides) {
  auto looks = looks_at(0.0, 10.0);
  for (sensors::Beam& look : looks) {
    look.range_m = look.range_m.value_or(0.5);
  }
  EXPECT_NEAR(bearing_deg(looks, 0.0), 0.0, 0.1);
}

TEST(LikelyBearing, BearsAMissingEcho) {
  auto looks = looks_at(0.0, 26.0);
  for (sensors::Beam& look : looks) {
    if (std::abs(look.bearing_rad - radians(20.0)) < 1e-9) {
      look.range_m.reset();
    }
  }
  EXPECT_NEAR(bearing_deg(looks, 0.0), 0.0, 3.0);
}

}  // namespace
}  // namespace echomap::mapping
