// SPDX-License-Identifier: MIT
#include "host/localization/polygon_view.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/support/drawn_map.hpp"

namespace echomap::localization {
namespace {

/// An L of two wings with a block in the lower one.
const mapping::PolygonMap kTwoWings(
    {{0.0, 0.0}, {3.0, 0.0}, {3.0, 1.0}, {1.0, 1.0}, {1.0, 2.0}, {0.0, 2.0}},
    {{{2.0, 0.4}, {2.2, 0.4}, {2.2, 0.6}, {2.0, 0.6}}});

TEST(PolygonView, ExpectsTheNearestWall) {
  const PolygonView view(kTwoWings, {.max_range_m = 5.0});
  EXPECT_NEAR(*view.expected({0.5, 0.5, 0.0}).range_m, 1.5, 1e-12);  // The block.
  EXPECT_NEAR(*view.expected({0.5, 0.2, 0.0}).range_m, 2.5, 1e-12);  // Past it.
  EXPECT_NEAR(*view.expected({0.5, 0.5, 1.5707963}).range_m, 1.5, 1e-6);
  const PolygonView short_sighted(kTwoWings, {.max_range_m = 1.4});
  EXPECT_FALSE(short_sighted.expected({0.5, 0.5, 0.0}).range_m);
}

TEST(PolygonView, SeesAWallAslantByItsNormal) {
  const PolygonView view(kTwoWings, {.max_range_m = 5.0, .oblique_above_rad = 0.4363});
  EXPECT_FALSE(view.expected({0.5, 0.2, 0.1}).is_oblique);
  EXPECT_FALSE(view.expected({0.5, 0.5, 3.14159 + 0.43}).is_oblique);
  EXPECT_TRUE(view.expected({0.5, 0.5, 3.14159 + 0.45}).is_oblique);
}

TEST(PolygonView, FloorIsInsideOfTheOutlineAndOutsideOfHoles) {
  const PolygonView view(kTwoWings);
  EXPECT_TRUE(view.is_floor({0.5, 1.5}));
  EXPECT_TRUE(view.is_floor({2.5, 0.5}));
  EXPECT_FALSE(view.is_floor({2.5, 1.5}));
  EXPECT_FALSE(view.is_floor({2.1, 0.5}));
  EXPECT_FALSE(view.is_floor({-0.1, 0.5}));
}

TEST(PolygonView, TellsAWallInFrontFromOneBehind) {
  const PolygonView view(kTwoWings);
  // The lower wall is abeam: in front of one that looks a little to it, behind the other.
  const models::WallAhead front = view.wall_ahead({0.5, 0.2, -0.1}, 0.1);
  EXPECT_NEAR(front.gap_m, 0.1, 1e-12);
  EXPECT_NEAR(front.bearing_rad, 0.1 - std::numbers::pi / 2.0, 1e-12);
  EXPECT_NEAR(front.ahead_m, 0.2 / std::sin(0.1) - 0.1, 1e-9);
  const models::WallAhead behind = view.wall_ahead({0.5, 0.2, 0.1}, 0.1);
  EXPECT_NEAR(behind.gap_m, std::hypot(0.5, 0.8) - 0.1, 1e-12);  // The corner at (1, 1).
  EXPECT_NEAR(behind.bearing_rad, std::atan2(0.8, 0.5) - 0.1, 1e-12);
}

TEST(PolygonView, RasterHasTheFloorsCells) {
  const mapping::RasterMap raster = rasterize(kTwoWings, 0.2);
  EXPECT_EQ(tests::drawing_of(raster),
            (tests::DrawnMap{".....##########",
                             ".....##########",
                             ".....##########",
                             ".....##########",
                             ".....##########",
                             "...............",
                             "...............",
                             "..........#....",
                             "...............",
                             "..............."}));
}

TEST(PolygonView, RefusesParametersWithoutSense) {
  EXPECT_THROW(PolygonView(kTwoWings, {.max_range_m = 0.0}), std::invalid_argument);
  EXPECT_THROW(rasterize(kTwoWings, 0.0), std::invalid_argument);
  EXPECT_THROW(rasterize(kTwoWings, std::nan("")), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::localization
