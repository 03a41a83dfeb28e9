// SPDX-License-Identifier: MIT
#include "host/mapping/sonar_surfaces.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"
#include "tests/host/mapping/default_params.hpp"
#include "tests/support/smooth_room.hpp"

namespace echomap::mapping {
namespace {

using geometry::radians;
using tests::scan_of;

TEST(FindSurfaces, PutsAWallAtTheMiddleOfItsRegion) {
  const auto found = find_surfaces(scan_of({{{radians(45.0), 1.5}}}), kSurfaceParams);
  ASSERT_EQ(found.surfaces.size(), 1U);
  EXPECT_NEAR(found.surfaces[0].bearing_rad, radians(45.0), radians(3.0));
  EXPECT_NEAR(found.surfaces[0].range_m, 1.5, 0.02);
  EXPECT_GT(found.surfaces[0].half_length_m, 0.1);
}

TEST(FindSurfaces, FindsAWallBehindTheCutOfTheCircle) {
  const auto found = find_surfaces(scan_of({{{radians(178.0), 1.0}}}), kSurfaceParams);
  ASSERT_EQ(found.surfaces.size(), 1U);
  EXPECT_NEAR(
      geometry::angle_between(found.surfaces[0].bearing_rad, radians(178.0)), 0.0, radians(3.0));
}

TEST(FindSurfaces, TellsTheFourWallsOfARoomApart) {
  const auto found = find_surfaces(scan_of({{{radians(0.0), 1.0},
                                             {radians(90.0), 1.4},
                                             {radians(180.0), 2.0},
                                             {radians(-90.0), 0.6}}}),
                                   kSurfaceParams);
  ASSERT_EQ(found.surfaces.size(), 4U);
  for (const auto& surface : found.surfaces) {
    const double quarter = std::round(surface.bearing_rad / radians(90.0));
    EXPECT_NEAR(surface.bearing_rad, quarter * radians(90.0), radians(4.0));
  }
}

TEST(FindSurfaces, HearsAPostOnlyAsWideAsTheBeam) {
  const Eigen::Vector2d post_m(0.9 * std::cos(radians(30.0)), 0.9 * std::sin(radians(30.0)));
  const auto found = find_surfaces(scan_of({{}, {post_m}}), kSurfaceParams);
  ASSERT_EQ(found.surfaces.size(), 1U);
  EXPECT_NEAR(found.surfaces[0].bearing_rad, radians(30.0), radians(3.0));
  EXPECT_EQ(found.surfaces[0].half_length_m, 0.0);
}

TEST(FindSurfaces, HearsAWallTowardsTheFootAndToBothSides) {
  const auto found = find_surfaces(scan_of({{{radians(45.0), 1.5}}}), kSurfaceParams);
  const SonarSurface& wall = found.surfaces.at(0);
  EXPECT_TRUE(wall.is_heard_towards(radians(45.0)));
  EXPECT_FALSE(wall.is_heard_towards(radians(100.0)));
  EXPECT_GT(wall.left_m, 0.1);
  EXPECT_GT(wall.right_m, 0.1);
}

TEST(FindSurfaces, IsSureOfNoSideThatEndsInAnotherThing) {
  // Beyond the beam's edge to the left a post answers from 7 cm behind the wall.
  Scan scan = scan_of({{{0.0, 1.2}}});
  for (PlacedReading& reading : scan) {
    const double bearing_rad = geometry::wrap_angle(reading.T_map_sonar.heading_rad());
    if (bearing_rad > radians(17.5) && bearing_rad < radians(38.0)) {
      reading.range_m = 1.28;
    }
  }
  const auto found = find_surfaces(scan, kSurfaceParams);
  const SonarSurface& wall = found.surfaces.at(0);
  EXPECT_EQ(wall.left_m, 0.0);
  EXPECT_GT(wall.right_m, 0.0);
}

TEST(FindSurfaces, DropsAGhostThatIsHeardNowAndThen) {
  Scan scan = scan_of({{{0.0, 1.0}}});
  scan[15].range_m = 3.1;
  scan[16].range_m = 2.2;
  scan[75].range_m = 3.1;
  EXPECT_EQ(find_surfaces(scan, kSurfaceParams).surfaces.size(), 1U);
}

TEST(FindSurfaces, BearsTheNoiseOfItsRanges) {
  Scan scan = scan_of({{{0.0, 1.0}, {radians(120.0), 1.8}}});
  for (std::size_t i = 0; i < scan.size(); ++i) {
    if (scan[i].range_m) {
      scan[i].range_m = *scan[i].range_m + (static_cast<double>(i * 7 % 11) - 5.0) * 0.01;
    }
  }
  const auto found = find_surfaces(scan, kSurfaceParams);
  ASSERT_EQ(found.surfaces.size(), 2U);
  for (const auto& surface : found.surfaces) {
    EXPECT_NEAR(surface.range_m, surface.bearing_rad < 1.0 ? 1.0 : 1.8, 0.04);
  }
}

TEST(FindSurfaces, SeesThemFromTheMiddleOfTheScan) {
  Scan scan = scan_of({{{0.0, 2.0}}}, {0.4, 0.0});
  const Scan other = scan_of({{{0.0, 2.0}}}, {0.2, 0.0});
  scan.insert(scan.end(), other.begin(), other.end());
  const auto found = find_surfaces(scan, kSurfaceParams);
  EXPECT_NEAR(found.center_m.x(), 0.3, 1e-12);
  ASSERT_EQ(found.surfaces.size(), 1U);
  EXPECT_NEAR(found.surfaces[0].range_m, 1.7, 0.03);
}

TEST(FindSurfaces, FindsNoneWithoutEcho) {
  EXPECT_TRUE(find_surfaces(scan_of({}), kSurfaceParams).surfaces.empty());
  EXPECT_TRUE(find_surfaces({}, kSurfaceParams).surfaces.empty());
}

}  // namespace
}  // namespace echomap::mapping
