// SPDX-License-Identifier: MIT
#include "host/localization/point_cloud_view.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/support/drawn_map.hpp"

namespace echomap::localization {
namespace {

TEST(PointCloudView, ExpectsTheNearestPointOnTheBeam) {
  const PointCloudView view({{2.0, 0.0}, {1.0, 0.0}, {0.5, 0.3}, {-0.2, 0.0}});
  const auto expected = view.expected({});
  ASSERT_TRUE(expected.range_m);
  EXPECT_DOUBLE_EQ(*expected.range_m, 1.0);
  EXPECT_FALSE(expected.is_oblique);
  EXPECT_NEAR(*view.expected({0.0, 0.0, 3.14159265}).range_m, 0.2, 1e-6);
}

TEST(PointCloudView, ABeamHasAWidthNearAndAnOpeningFar) {
  const PointCloudView view({{0.3, 0.025}, {2.0, 0.08}});
  EXPECT_NEAR(*view.expected({}).range_m, 0.3, 1e-6);
  EXPECT_NEAR(*view.expected({0.4, 0.0, 0.0}).range_m, 1.6, 1e-6);
  EXPECT_FALSE(view.expected({0.0, 0.15, 1.0}).range_m);
  EXPECT_FALSE(view.expected({1.0, 0.0, 0.0}).range_m);  // 4.6 degrees off.
}

TEST(PointCloudView, NothingIsBeyondTheSensorsRange) {
  const PointCloudView view({{2.6, 0.0}});
  EXPECT_FALSE(view.expected({}).range_m);
  EXPECT_TRUE(view.expected({0.1, 0.0, 0.0}).range_m);
}

TEST(OccupiedPoints, AreTheMiddlesOfOccupiedCells) {
  const auto points_m = occupied_points(tests::map_from({"#.", ". "}, 0.5, {1.0, 2.0}));
  ASSERT_EQ(points_m.size(), 1U);
  EXPECT_EQ(points_m[0], Eigen::Vector2d(1.25, 2.75));
}

TEST(PointCloudView, RefusesParametersWithoutSense) {
  EXPECT_THROW(PointCloudView({}, {.half_width_m = 0.0}), std::invalid_argument);
  EXPECT_THROW(PointCloudView({}, {.beam_half_angle_rad = -0.1}), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::localization
