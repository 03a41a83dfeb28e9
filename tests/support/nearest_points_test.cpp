// SPDX-License-Identifier: MIT
#include "tests/support/nearest_points.hpp"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

namespace echomap::tests {
namespace {

std::vector<Eigen::Vector2d> random_points(std::mt19937& random, std::size_t count) {
  std::uniform_real_distribution<double> place_m(-2.0, 2.0);
  std::vector<Eigen::Vector2d> points;
  for (std::size_t i = 0; i < count; ++i) {
    points.emplace_back(place_m(random), place_m(random));
  }
  return points;
}

TEST(NearestPoints, AreThoseThatGoingThroughAllOfThemFinds) {
  std::mt19937 random(1);
  for (const std::size_t count : {1U, 2U, 11U, 500U}) {
    const auto points = random_points(random, count);
    const NearestPoints index(points);
    for (const auto& place : random_points(random, 100)) {
      std::vector<double> distances;
      for (const auto& point : points) {
        distances.push_back((point - place).norm());
      }
      std::sort(distances.begin(), distances.end());
      const auto found = index.nearest(place, 5);
      ASSERT_EQ(found.size(), std::min<std::size_t>(5, count));
      for (std::size_t i = 0; i < found.size(); ++i) {
        EXPECT_NEAR(found[i].distance_m, distances[i], 1e-12);
        EXPECT_NEAR((points[found[i].index] - place).norm(), found[i].distance_m, 1e-12);
      }
      EXPECT_EQ(index.nearest(place)->index, found.front().index);
    }
  }
}

TEST(NearestPoints, OfNoneIsEmpty) {
  const NearestPoints index({});
  EXPECT_FALSE(index.nearest({0.0, 0.0}));
  EXPECT_TRUE(index.nearest({0.0, 0.0}, 3).empty());
}

TEST(NearestPoints, MayBeMoved) {
  NearestPoints first({{1.0, 0.0}, {5.0, 0.0}});
  const NearestPoints second(std::move(first));
  EXPECT_EQ(second.nearest({4.0, 0.0})->index, 1U);
}

}  // namespace
}  // namespace echomap::tests
