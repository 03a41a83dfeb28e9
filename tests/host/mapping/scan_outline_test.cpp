// SPDX-License-Identifier: MIT
#include "host/mapping/scan_outline.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"

namespace echomap::mapping {
namespace {

using geometry::radians;

constexpr double kAnyGapRad = 3.2;

ScanSurfaces posts(const std::vector<std::pair<double, double>>& degrees_and_metres) {
  ScanSurfaces scan;
  for (const auto& [bearing_deg, range_m] : degrees_and_metres) {
    scan.surfaces.push_back({radians(bearing_deg), range_m, 0.0, 10});
  }
  return scan;
}

TEST(ScanOutline, RunsStraightFromPostToPost) {
  const ScanOutline outline(posts({{0.0, 1.0}, {90.0, 1.0}, {180.0, 1.0}, {-90.0, 1.0}}),
                            kAnyGapRad);
  EXPECT_NEAR(outline.range_m(0.0), 1.0, 1e-9);
  EXPECT_NEAR(outline.range_m(radians(45.0)), std::sqrt(0.5), 1e-9);
  EXPECT_NEAR(outline.range_m(radians(-135.0)), std::sqrt(0.5), 1e-9);
  EXPECT_NEAR(outline.range_m(radians(180.0)), 1.0, 1e-9);
  EXPECT_NEAR(outline.range_m(radians(-179.999)), 1.0, 1e-4);
}

TEST(ScanOutline, FollowsAWallAsFarAsItReaches) {
  ScanSurfaces scan = posts({{180.0, 1.0}});
  scan.surfaces.push_back({0.0, 2.0, 1.0, 10});
  const ScanOutline outline(scan, kAnyGapRad);
  const double end_rad = std::atan2(1.0, 2.0);
  for (double bearing_rad = -end_rad; bearing_rad <= end_rad; bearing_rad += 0.05) {
    EXPECT_NEAR(outline.range_m(bearing_rad), 2.0 / std::cos(bearing_rad), 1e-9);
  }
  EXPECT_NEAR(outline.max_m(), std::sqrt(5.0), 1e-9);
}

TEST(ScanOutline, KnowsNothingInAWideGap) {
  const ScanOutline outline(posts({{0.0, 1.0}, {40.0, 1.0}, {150.0, 1.0}}), radians(60.0));
  EXPECT_GT(outline.range_m(radians(20.0)), 0.9);
  EXPECT_EQ(outline.range_m(radians(100.0)), 0.0);
  EXPECT_EQ(outline.range_m(radians(-100.0)), 0.0);
}

TEST(ScanOutline, OfNothingIsNothing) {
  const ScanOutline outline({}, kAnyGapRad);
  EXPECT_EQ(outline.range_m(1.0), 0.0);
  EXPECT_EQ(outline.max_m(), 0.0);
}

TEST(ScanOutline, OfOneSurfaceIsThatSurface) {
  const ScanOutline outline(posts({{0.0, 1.0}}), kAnyGapRad);
  EXPECT_EQ(outline.range_m(2.0), 0.0);
}

}  // namespace
}  // namespace echomap::mapping
