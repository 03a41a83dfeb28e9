// SPDX-License-Identifier: MIT
#include "host/mapping/cylinder_detection.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "host/geometry/unit_vector.hpp"

namespace echomap::mapping {
namespace {

constexpr double kRadiusM = 0.045;
constexpr double kBeamRad = 0.006;
constexpr double kWallM = 3.0;

/// Where a beam meets a disc.
std::optional<double> range_of(const Eigen::Vector2d& center_m, double bearing_rad) {
  const Eigen::Vector2d along = geometry::unit_vector(bearing_rad);
  const double ahead_m = along.dot(center_m);
  const double off_m = std::abs(along.x() * center_m.y() - along.y() * center_m.x());
  if (ahead_m < 0.0 || off_m > kRadiusM) {
    return std::nullopt;
  }
  return ahead_m - std::sqrt(kRadiusM * kRadiusM - off_m * off_m);
}

/// A scan among cylinders in a round room.
std::vector<Eigen::Vector2d> scan(const std::vector<Eigen::Vector2d>& centers_m, double noise_m) {
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0.0, noise_m);
  std::vector<Eigen::Vector2d> points_m;
  for (double bearing_rad = -2.0; bearing_rad < 2.0; bearing_rad += kBeamRad) {
    double range_m = kWallM;
    for (const Eigen::Vector2d& center_m : centers_m) {
      range_m = std::min(range_m, range_of(center_m, bearing_rad).value_or(kWallM));
    }
    points_m.emplace_back((range_m + noise(random)) * geometry::unit_vector(bearing_rad));
  }
  return points_m;
}

CylinderDetectionParams params() {
  CylinderDetectionParams params;
  params.radius_m = kRadiusM;
  return params;
}

TEST(CylinderDetection, FindsEveryCylinderWhereItStands) {
  const std::vector<Eigen::Vector2d> centers_m = {{0.1, -0.5}, {1.2, -0.2}, {1.0, 0.9}, {0.2, 2.0}};
  const auto found_m = find_cylinders(scan(centers_m, 0.003), params());
  ASSERT_EQ(found_m.size(), centers_m.size());
  for (std::size_t i = 0; i < centers_m.size(); ++i) {
    EXPECT_LT((found_m[i] - centers_m[i]).norm(), 0.015) << i;
  }
}

TEST(CylinderDetection, FindsNoneInARoomWithoutAndInNoScanAtAll) {
  EXPECT_TRUE(find_cylinders(scan({}, 0.003), params()).empty());
  EXPECT_TRUE(find_cylinders({}, params()).empty());
}

TEST(CylinderDetection, LeavesOutWhatIsTooWide) {
  // Two that touch look like one of twice the width.
  EXPECT_TRUE(find_cylinders(scan({{1.0, 0.045}, {1.0, -0.045}}, 0.0), params()).empty());
}

TEST(CylinderDetection, LeavesOutWhatIsHiddenInPart) {
  const Eigen::Vector2d before_m(0.8, 0.0);
  const auto found_m = find_cylinders(scan({before_m, {1.5, 0.08}}, 0.0), params());
  ASSERT_EQ(found_m.size(), 1U);
  EXPECT_LT((found_m[0] - before_m).norm(), 0.01);
}

TEST(CylinderDetection, RefusesParametersWithoutSense) {
  CylinderDetectionParams params;
  params.radius_m = 0.0;
  EXPECT_THROW(find_cylinders({}, params), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::mapping
