// SPDX-License-Identifier: MIT
#include "host/geometry/segment.hpp"

#include <gtest/gtest.h>

namespace echomap::geometry {
namespace {

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
