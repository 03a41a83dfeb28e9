// SPDX-License-Identifier: MIT
#include "host/slam/scan_gathering.hpp"

#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include "host/sensors/range_scan.hpp"

namespace echomap::slam {
namespace {

sensors::RangeScan ahead(double range_m) { return {{}, {}, {{0.0, range_m}}}; }

TEST(ScanGathering, PutsPointsIntoTheFrameOfTheLastScan) {
  ScanGathering gathering;
  gathering.add({0.0, 0.0, 0.0}, ahead(3.0));
  gathering.add({1.0, 0.0, std::numbers::pi / 2}, ahead(3.0));
  const auto points_m = gathering.points_m();
  ASSERT_EQ(points_m.size(), 2U);
  EXPECT_LT((points_m[0] - Eigen::Vector2d(0.0, -2.0)).norm(), 1e-12);
  EXPECT_LT((points_m[1] - Eigen::Vector2d(3.0, 0.0)).norm(), 1e-12);
}

TEST(ScanGathering, IsEnoughByPointsByWayOrByScans) {
  ScanGathering by_points({100.0, 0.03, 2, 100.0, 100});
  by_points.add({}, ahead(3.0));
  EXPECT_FALSE(by_points.is_enough());
  by_points.add({}, ahead(3.0));
  EXPECT_TRUE(by_points.is_enough());

  ScanGathering by_distance({100.0, 0.03, 100, 1.0, 100});
  by_distance.add({}, {});
  EXPECT_FALSE(by_distance.is_enough());
  by_distance.add({1.1, 0.0, 0.0}, {});
  EXPECT_TRUE(by_distance.is_enough());

  ScanGathering by_scans({100.0, 0.03, 100, 1.0, 3});
  for (int i = 0; i < 3; ++i) {
    EXPECT_FALSE(by_scans.is_enough());
    by_scans.add({}, {});
  }
  EXPECT_TRUE(by_scans.is_enough());
  by_scans.clear();
  EXPECT_FALSE(by_scans.is_enough());
}

TEST(ScanGathering, LeavesOutPointsBesideTheOneBefore) {
  ScanGathering gathering({100.0, 0.05, 80, 2.0, 40});
  gathering.add({}, {{}, {}, {{0.0, 2.0}, {0.01, 2.0}, {0.02, 2.0}, {0.03, 2.0}}});
  EXPECT_EQ(gathering.points_m().size(), 2U) << "2 cm from beam to beam";
}

TEST(ScanGathering, LeavesOutWhatIsTooFarOrNoNumber) {
  ScanGathering gathering;
  constexpr double kFar = std::numeric_limits<double>::infinity();
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  gathering.add({}, {{}, {}, {{0.0, 101.0}, {0.1, kFar}, {0.2, kNone}, {0.3, 5.0}}});
  EXPECT_EQ(gathering.points_m().size(), 1U);
}

TEST(ScanGathering, RefusesParametersWithoutSense) {
  EXPECT_THROW(ScanGathering({100.0, -0.1, 80, 2.0, 40}), std::invalid_argument);
  EXPECT_THROW(ScanGathering({100.0, 0.1, 0, 2.0, 40}), std::invalid_argument);
  EXPECT_THROW(ScanGathering({100.0, 0.1, 80, 0.0, 40}), std::invalid_argument);
  EXPECT_THROW(ScanGathering({100.0, 0.1, 80, 2.0, 0}), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::slam
