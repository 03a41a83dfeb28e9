// SPDX-License-Identifier: MIT
#include "host/exploration/front_view.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"

namespace echomap::exploration {
namespace {

using geometry::degrees;
using geometry::Pose2;
using geometry::radians;

constexpr double kHalfViewRad = 0.5 * std::numbers::pi;

/// A scan from the pose, all readings at these ranges, every 30 degrees from straight ahead.
mapping::Scan scan_at(const Pose2& T_map_robot, const std::vector<double>& ranges_m) {
  mapping::Scan scan;
  for (std::size_t i = 0; i < ranges_m.size(); ++i) {
    const Pose2 T_robot_sonar(0.0, 0.0, radians(30.0 * static_cast<double>(i)));
    const bool is_heard = ranges_m[i] > 0.0;
    scan.push_back({T_map_robot,
                    T_map_robot * T_robot_sonar,
                    is_heard ? std::optional(ranges_m[i]) : std::nullopt});
  }
  return scan;
}

std::vector<ViewedRange> view_of(const std::vector<double>& ranges_m) {
  std::vector<ViewedRange> view;
  for (const double range_m : ranges_m) {
    const double bearing_deg =
        -90.0 + 180.0 * static_cast<double>(view.size()) / static_cast<double>(ranges_m.size() - 1);
    view.push_back({radians(bearing_deg), range_m});
  }
  return view;
}

TEST(FrontView, IsTheHalfTowardsTheGoalFromRightToLeft) {
  const Pose2 T_map_robot(3.0, -1.0, radians(70.0));
  const auto scan =
      scan_at(T_map_robot, {1.0, 1.1, 1.2, 1.3, 1.4, 1.5, 1.6, 1.7, 1.8, 1.9, 2.0, 2.1});
  const auto view = front_view(scan, T_map_robot, radians(70.0 + 60.0), kHalfViewRad + 0.01, 9.0);
  ASSERT_EQ(view.size(), 7U);
  EXPECT_NEAR(degrees(view.front().bearing_rad), -90.0, 1e-9);
  EXPECT_NEAR(view.front().range_m, 2.1, 1e-9);
  EXPECT_NEAR(degrees(view.back().bearing_rad), 90.0, 1e-9);
  EXPECT_NEAR(view.back().range_m, 1.5, 1e-9);
}

TEST(FrontView, TakesSilenceForFar) {
  const auto view = front_view(scan_at({}, {0.0}), {}, 0.0, kHalfViewRad, 2.5);
  ASSERT_EQ(view.size(), 1U);
  EXPECT_NEAR(view[0].range_m, 2.5, 1e-12);
}

TEST(FrontView, SeesFromTheRobotsMiddleAndNotFromItsSonar) {
  const mapping::Scan scan{{{}, Pose2(0.1, 0.0, radians(90.0)), 0.1}};
  const auto view = front_view(scan, {}, 0.0, kHalfViewRad, 2.5);
  ASSERT_EQ(view.size(), 1U);
  EXPECT_NEAR(degrees(view[0].bearing_rad), 45.0, 1e-9);
  EXPECT_NEAR(view[0].range_m, std::hypot(0.1, 0.1), 1e-12);
}

TEST(Discontinuities, AreWhereNeighboursDifferByMore) {
  const auto torn = discontinuities(view_of({1.0, 1.2, 1.4, 0.5, 0.5, 2.0, 2.1}), 0.25);
  ASSERT_EQ(torn.size(), 2U);
  EXPECT_EQ(torn[0].free_side, -1);
  EXPECT_EQ(torn[0].near.range_m, 0.5);
  EXPECT_NEAR(degrees(torn[0].near.bearing_rad), 0.0, 1e-9);
  EXPECT_EQ(torn[1].free_side, 1);
  EXPECT_NEAR(degrees(torn[1].near.bearing_rad), 30.0, 1e-9);
}

TEST(Discontinuities, KnowHowWideTheOpeningBetweenThemIs) {
  const auto torn = discontinuities(view_of({2.0, 0.5, 2.0, 2.0, 2.0, 0.5, 0.5}), 0.25);
  ASSERT_EQ(torn.size(), 3U);
  EXPECT_TRUE(std::isinf(torn[0].width_m));
  // 60 degrees to the right, 60 to the left, each 0.5 m away.
  EXPECT_NEAR(torn[1].width_m, 2.0 * 0.5 * std::sin(radians(60.0)), 1e-9);
  EXPECT_EQ(torn[2].width_m, torn[1].width_m);
}

TEST(Discontinuities, AreNoneInASmoothOrEmptyView) {
  EXPECT_TRUE(discontinuities(view_of({1.0, 1.1, 1.2, 1.1}), 0.25).empty());
  EXPECT_TRUE(discontinuities({}, 0.25).empty());
}

}  // namespace
}  // namespace echomap::exploration
