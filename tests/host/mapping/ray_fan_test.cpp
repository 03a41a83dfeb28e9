// SPDX-License-Identifier: MIT
#include "host/mapping/ray_fan.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"

namespace echomap::mapping {
namespace {

constexpr double kCell = 1 << kLatticeBits;

LatticePoint direction(double bearing_deg, double cells) {
  const double bearing_rad = geometry::radians(bearing_deg);
  return {2 * static_cast<std::int32_t>(std::lround(0.5 * kCell * cells * std::cos(bearing_rad))),
          2 * static_cast<std::int32_t>(std::lround(0.5 * kCell * cells * std::sin(bearing_rad)))};
}

/// One ray a degree from the first to before the last bearing, 100 cells long.
std::vector<LatticePoint> fan_of(int first_deg, int last_deg) {
  std::vector<LatticePoint> directions;
  for (int bearing_deg = first_deg; bearing_deg < last_deg; ++bearing_deg) {
    directions.push_back(direction(bearing_deg + 0.5, 100.0));
  }
  return directions;
}

/// In cells, counter-clockwise from ahead left.
std::vector<double> radii_of(const std::vector<LatticePoint>& directions) {
  RayFan fan;
  fan.reset(directions);
  std::vector<double> radii;
  for (const Quadrant quadrant :
       {Quadrant::kRightUp, Quadrant::kLeftUp, Quadrant::kLeftDown, Quadrant::kRightDown}) {
    radii.push_back(fan.radius(quadrant) / kCell);
  }
  return radii;
}

/// Between rays of one degree.
auto is_dense() { return testing::DoubleNear(57.29, 0.3); }

TEST(RayFan, CrossesAllUpToWhereNeighboursAreACellApart) {
  auto directions = fan_of(0, 360);
  EXPECT_THAT(radii_of(directions), testing::Each(is_dense()));
  std::reverse(directions.begin(), directions.end());
  EXPECT_THAT(radii_of(directions), testing::Each(is_dense()));
  directions.insert(directions.begin() + 100, 20, directions[100]);
  EXPECT_THAT(radii_of(directions), testing::Each(is_dense()));
}

TEST(RayFan, IsCutByAShortRayInItsQuadrantOnly) {
  auto directions = fan_of(0, 360);
  directions[130] = direction(130.5, 12.0);
  EXPECT_THAT(
      radii_of(directions),
      testing::ElementsAre(is_dense(), testing::DoubleNear(12.0, 0.1), is_dense(), is_dense()));
}

TEST(RayFan, CrossesNothingInQuadrantsWithAGap) {
  EXPECT_THAT(radii_of(fan_of(-10, 190)), testing::ElementsAre(is_dense(), is_dense(), 0.0, 0.0));
  const auto sparse = testing::DoubleNear(1.0 / std::tan(geometry::radians(61.0)), 0.01);
  EXPECT_THAT(radii_of(fan_of(0, 300)),
              testing::ElementsAre(sparse, is_dense(), is_dense(), sparse));
  EXPECT_THAT(radii_of(fan_of(10, 80)), testing::Each(0.0));
}

TEST(RayFan, CrossesNothingWithoutAnOrder) {
  EXPECT_THAT(radii_of({}), testing::Each(0.0));
  EXPECT_THAT(radii_of({direction(30.0, 50.0)}), testing::Each(0.0));
  EXPECT_THAT(radii_of({direction(30.0, 50.0), direction(30.0, 60.0)}), testing::Each(0.0));
  EXPECT_THAT(radii_of({direction(30.0, 50.0), direction(31.0, 50.0)}), testing::Each(0.0));
  auto directions = fan_of(0, 360);
  std::swap(directions[30], directions[32]);
  EXPECT_THAT(radii_of(directions), testing::Each(0.0));
}

TEST(RayFan, CoversARayUpToHalfADiagonalBeforeTheEdge) {
  RayFan fan;
  auto directions = fan_of(0, 360);
  fan.reset(directions);
  const double dense = fan.radius(Quadrant::kRightUp) / kCell;
  EXPECT_NEAR(100.0 * fan.covered_shares()[45], dense - 0.708, 0.01);
  directions[130] = direction(130.5, 12.0);
  fan.reset(directions);
  EXPECT_NEAR(100.0 * fan.covered_shares()[45], dense - 0.708, 0.01);
  EXPECT_NEAR(100.0 * fan.covered_shares()[89], 12.0 - 0.708, 0.01) << "close to the axis";
}

}  // namespace
}  // namespace echomap::mapping
