// SPDX-License-Identifier: MIT

#include "host/sensors/range_scan.hpp"

#include <numbers>
#include <optional>

#include <gtest/gtest.h>

namespace echomap::sensors {
namespace {

TEST(EndPoints, LieWhereTheSensorOnTheRobotSeesThem) {
  const RangeScan scan{
      {}, {0.1, 0.0, std::numbers::pi / 2}, {{0.0, 2.0}, {std::numbers::pi / 2, 1.0}}};

  const auto points_m = end_points_m(scan, 10.0);

  ASSERT_EQ(points_m.size(), 2U);
  EXPECT_LT((points_m[0] - Eigen::Vector2d(0.1, 2.0)).norm(), 1e-12);
  EXPECT_LT((points_m[1] - Eigen::Vector2d(-0.9, 0.0)).norm(), 1e-12);
}

TEST(EndPoints, LeaveOutWhatDidNotAnswerAndWhatIsTooFar) {
  const RangeScan scan{{}, {}, {{0.0, std::nullopt}, {0.1, 4.0}, {0.2, 4.1}}};

  EXPECT_EQ(end_points_m(scan, 4.0).size(), 1U);
}

TEST(InFrame, MovesEachPointAsThePoseDoes) {
  const geometry::Pose2 T_a_b(1.0, -2.0, 0.7);
  const std::vector<Eigen::Vector2d> points_b_m{{0.0, 0.0}, {3.0, 1.0}};
  const auto points_a_m = in_frame_a_m(T_a_b, points_b_m);
  ASSERT_EQ(points_a_m.size(), 2U);
  EXPECT_LT((points_a_m[0] - T_a_b.position_m()).norm(), 1e-12);
  EXPECT_LT((points_a_m[1] - T_a_b * points_b_m[1]).norm(), 1e-12);
}

}  // namespace
}  // namespace echomap::sensors
