// SPDX-License-Identifier: MIT
#include "host/mapping/scan_alignment.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/smooth_room.hpp"

namespace echomap::mapping {
namespace {

using geometry::radians;
using tests::scan_of;
using tests::SmoothRoom;

const SmoothRoom kRoom = tests::smooth_rectangle();

const std::vector<Eigen::Vector2d> kStops{
    {0.0, 0.0}, {0.5, 0.2}, {-0.4, 0.3}, {0.2, -0.2}, {0.7, 0.4}, {-0.6, -0.1}};

/// The stops as an odometry sees them that turns by `drift_rad` more at each.
std::vector<ScanSurfaces> drifted(const SmoothRoom& room, double drift_rad) {
  std::vector<ScanSurfaces> scans;
  geometry::Pose2 T_odom_stop;
  for (std::size_t i = 0; i < kStops.size(); ++i) {
    const Eigen::Vector2d offset_m =
        i == 0 ? kStops[0] : Eigen::Vector2d(kStops[i] - kStops[i - 1]);
    T_odom_stop = T_odom_stop * geometry::Pose2(offset_m.x(), offset_m.y(), 0.0);
    ScanSurfaces scan = find_surfaces(scan_of(room, kStops[i]), {});
    scan.center_m = T_odom_stop.position_m();
    for (SonarSurface& surface : scan.surfaces) {
      surface.bearing_rad = geometry::wrap_angle(surface.bearing_rad + T_odom_stop.heading_rad());
    }
    scans.push_back(scan);
    T_odom_stop = T_odom_stop * geometry::Pose2(0.0, 0.0, drift_rad);
  }
  return scans;
}

double max_distance_off_m(const std::vector<ScanSurfaces>& scans) {
  double max_m = 0.0;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    max_m = std::max(max_m, (scans[i].center_m - kStops[i]).norm());
  }
  return max_m;
}

TEST(AlignScans, TakesOutMostOfADriftOfTheOdometry) {
  const auto scans = drifted(kRoom, radians(2.0));
  ASSERT_GT(max_distance_off_m(scans), 0.08);
  const AlignedScans aligned = align_scans(scans, {}, {});
  EXPECT_LT(max_distance_off_m(aligned.scans), 0.5 * max_distance_off_m(scans));
  ASSERT_EQ(aligned.T_map_placed.size(), scans.size());
  EXPECT_NEAR(aligned.T_map_placed.back().heading_rad(), -5.0 * radians(2.0), 2.5 * radians(2.0));
  for (std::size_t i = 0; i < scans.size(); ++i) {
    const Eigen::Vector2d center_m = aligned.T_map_placed[i] * scans[i].center_m;
    EXPECT_NEAR((center_m - aligned.scans[i].center_m).norm(), 0.0, 1e-9);
  }
}

TEST(AlignScans, LeavesAnOdometryThatIsRight) {
  EXPECT_LT(max_distance_off_m(align_scans(drifted(kRoom, 0.0), {}, {}).scans), 0.01);
}

TEST(AlignScans, KeepsToTheOdometryWhereNothingIsSeen) {
  const auto scans = drifted({}, radians(2.0));
  const AlignedScans aligned = align_scans(scans, {}, {});
  for (std::size_t i = 0; i < scans.size(); ++i) {
    EXPECT_NEAR((aligned.scans[i].center_m - scans[i].center_m).norm(), 0.0, 1e-9);
  }
  EXPECT_NEAR(aligned.T_map_placed.back().heading_rad(), 0.0, 1e-9);
}

/// One endless wall tells how far off it the stops were, and nothing of the way along it.
TEST(AlignScans, KeepsToTheOdometryAlongASingleWall) {
  const auto scans = drifted({{{radians(90.0), 0.9}}}, 0.0);
  const AlignedScans aligned = align_scans(scans, {}, {});
  for (std::size_t i = 0; i < scans.size(); ++i) {
    EXPECT_NEAR(aligned.scans[i].center_m.x(), scans[i].center_m.x(), 0.01);
  }
}

TEST(AlignScans, OfNoneOrOneChangesNothing) {
  EXPECT_TRUE(align_scans({}, {}, {}).scans.empty());
  const auto scans = drifted(kRoom, 0.0);
  const AlignedScans aligned = align_scans({scans.front()}, {}, {});
  EXPECT_EQ(aligned.scans.front().center_m, scans.front().center_m);
}

}  // namespace
}  // namespace echomap::mapping
