// SPDX-License-Identifier: MIT
#include "host/geometry/segment.hpp"

#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

namespace echomap::geometry {
namespace {

//   y
//   2 |  D       B
//   1 |     X
//   0 |  A       C
//        0   1   2  x
const Segment rising{{0.0, 0.0}, {2.0, 2.0}};
const Segment falling{{0.0, 2.0}, {2.0, 0.0}};

TEST(Segment, NearestPointIsTheFootOrAnEnd) {
  const Segment floor{{1.0, 0.0}, {3.0, 0.0}};
  EXPECT_EQ(nearest_point(floor, {2.5, 1.0}), Eigen::Vector2d(2.5, 0.0));
  EXPECT_EQ(nearest_point(floor, {0.0, 1.0}), Eigen::Vector2d(1.0, 0.0));
  EXPECT_EQ(nearest_point(floor, {9.0, -4.0}), Eigen::Vector2d(3.0, 0.0));
  EXPECT_EQ(nearest_point({{1.0, 1.0}, {1.0, 1.0}}, {5.0, 5.0}), Eigen::Vector2d(1.0, 1.0));
}

TEST(Segment, RayMeetsWhatIsBeforeItOnly) {
  const Segment wall{{2.0, -1.0}, {2.0, 1.0}};
  EXPECT_DOUBLE_EQ(ray_distance_m({0.5, 0.0}, {1.0, 0.0}, wall).value(), 1.5);
  EXPECT_FALSE(ray_distance_m({0.5, 0.0}, {-1.0, 0.0}, wall));
  EXPECT_FALSE(ray_distance_m({0.5, 1.5}, {1.0, 0.0}, wall));
  EXPECT_FALSE(ray_distance_m({0.5, 0.0}, {0.0, 1.0}, wall)) << "parallel";
}

TEST(Segment, RayHitLiesOnTheSegment) {
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> place(-5.0, 5.0);
  int hits = 0;
  for (int i = 0; i < 2000; ++i) {
    const Segment wall{{place(generator), place(generator)}, {place(generator), place(generator)}};
    const Eigen::Vector2d origin(place(generator), place(generator));
    const double bearing_rad = place(generator);
    const Eigen::Vector2d direction(std::cos(bearing_rad), std::sin(bearing_rad));
    if (const auto distance_m = ray_distance_m(origin, direction, wall)) {
      const Eigen::Vector2d hit = origin + *distance_m * direction;
      EXPECT_LT((nearest_point(wall, hit) - hit).norm(), 1e-9);
      ++hits;
    }
  }
  EXPECT_GT(hits, 200);
}

TEST(Segment, TouchingIsNotCrossing) {
  const Segment half{{0.0, 2.0}, {1.0, 1.0}};
  EXPECT_TRUE(cross_properly(rising, falling));
  EXPECT_FALSE(cross_properly(rising, half));
  EXPECT_TRUE(touch(rising, half));
  EXPECT_FALSE(touch(rising, {{0.0, 1.0}, {0.0, 3.0}}));
}

TEST(Segment, NormalPointsToTheLeft) {
  const Eigen::Vector2d normal = left_normal(rising);
  EXPECT_NEAR(normal.x(), -std::numbers::sqrt2 / 2.0, 1e-12);
  EXPECT_NEAR(normal.y(), std::numbers::sqrt2 / 2.0, 1e-12);
}

const Segment kWall{{0.0, 0.0}, {4.0, 0.0}};

TEST(Segment, KnowsItsLength) { EXPECT_DOUBLE_EQ(kWall.length_m(), 4.0); }

TEST(Segment, IsNearestAtTheFootOfThePerpendicular) {
  EXPECT_EQ(nearest_point(kWall, {1.5, 2.0}), Eigen::Vector2d(1.5, 0.0));
  EXPECT_DOUBLE_EQ(distance_m(kWall, {1.5, -2.0}), 2.0);
}

TEST(Segment, IsNearestAtAnEndBeyondIt) {
  EXPECT_EQ(nearest_point(kWall, {7.0, 4.0}), Eigen::Vector2d(4.0, 0.0));
  EXPECT_DOUBLE_EQ(distance_m(kWall, {7.0, 4.0}), 5.0);
  EXPECT_DOUBLE_EQ(distance_m(kWall, {-3.0, 4.0}), 5.0);
}

TEST(Segment, WithoutLengthIsAPoint) {
  const Segment point{{1.0, 1.0}, {1.0, 1.0}};
  EXPECT_DOUBLE_EQ(distance_m(point, {4.0, 5.0}), 5.0);
}

}  // namespace
}  // namespace echomap::geometry
