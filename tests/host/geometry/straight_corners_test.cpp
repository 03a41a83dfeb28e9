// SPDX-License-Identifier: MIT
#include "host/geometry/straight_corners.hpp"

#include <algorithm>

#include <gtest/gtest.h>

namespace echomap::geometry {
namespace {

const Polygon kSquareM{{0, 0}, {1, 0}, {1, 1}, {0, 1}};

TEST(StraightCorners, AreLeftOutWhereverTheRingBegins) {
  Polygon ring_m{{0, 0}, {0.3, 0}, {0.6, 0.0005}, {1, 0}, {1, 1}, {0, 1}, {0, 0.5}};
  for (std::size_t i = 0; i < ring_m.size(); ++i) {
    EXPECT_EQ(without_straight_corners(ring_m, 0.001).size(), 4U) << i;
    std::rotate(ring_m.begin(), ring_m.begin() + 1, ring_m.end());
  }
  EXPECT_EQ(without_straight_corners(ring_m, 0.001), kSquareM);
  EXPECT_EQ(without_straight_corners(ring_m, 0.0001).size(), 6U);
}

TEST(StraightCorners, LeaveATriangle) {
  EXPECT_EQ(without_straight_corners({{0, 0}, {1, 0}, {2, 0}, {3, 0}}, 0.001).size(), 3U);
  EXPECT_EQ(without_straight_corners(kSquareM, 10.0).size(), 3U);
  EXPECT_TRUE(without_straight_corners({}, 0.001).empty());
}

}  // namespace
}  // namespace echomap::geometry
