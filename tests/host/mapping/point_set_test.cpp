// SPDX-License-Identifier: MIT
#include "host/mapping/point_set.hpp"

#include <gtest/gtest.h>

namespace echomap::mapping {
namespace {

TEST(PointSet, TakesSomeSpreadOverAllAndTheirMean) {
  const std::vector<Eigen::Vector2d> points{{0, 0}, {1, 0}, {2, 0}, {3, 4}};
  EXPECT_EQ(some_of(points, 4), points);
  const std::vector<Eigen::Vector2d> some{{0, 0}, {2, 0}};
  EXPECT_EQ(some_of(points, 2), some);
  EXPECT_EQ(mean_of(points), Eigen::Vector2d(1.5, 1.0));
}

}  // namespace
}  // namespace echomap::mapping
