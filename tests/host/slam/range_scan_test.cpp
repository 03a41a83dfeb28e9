// SPDX-License-Identifier: MIT
#include "host/slam/range_scan.hpp"

#include <numbers>
#include <optional>

#include <gtest/gtest.h>

namespace echomap::slam {
namespace {

TEST(EndPoints, LieWhereTheSensorOnTheRobotSeesThem) {
  const RangeScan scan{{0.1, 0.0, std::numbers::pi / 2}, {{0.0, 2.0}, {std::numbers::pi / 2, 1.0}}};

  const auto points_m = end_points_m(scan, 10.0);

  ASSERT_EQ(points_m.size(), 2U);
  EXPECT_LT((points_m[0] - Eigen::Vector2d(0.1, 2.0)).norm(), 1e-12);
  EXPECT_LT((points_m[1] - Eigen::Vector2d(-0.9, 0.0)).norm(), 1e-12);
}

TEST(EndPoints, LeaveOutWhatDidNotAnswerAndWhatIsTooFar) {
  const RangeScan scan{{}, {{0.0, std::nullopt}, {0.1, 4.0}, {0.2, 4.1}}};

  EXPECT_EQ(end_points_m(scan, 4.0).size(), 1U);
}

}  // namespace
}  // namespace echomap::slam
