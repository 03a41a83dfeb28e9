// SPDX-License-Identifier: MIT
#include "host/mapping/ring_loops.hpp"

#include <gtest/gtest.h>

#include "host/geometry/touching_sides.hpp"

namespace echomap::mapping {
namespace {

using geometry::Polygon;

/// A room of 2 x 1 m whose sides cross at its right end: beyond that a loop of so much width.
Polygon room_with_loop(double width_m) {
  return {{0, 0}, {2, 0}, {2 + width_m, 1}, {2 + width_m, 0}, {2, 1}, {0, 1}};
}

TEST(RingLoops, AreCutOffWhereTheyAreSmall) {
  const Polygon rest_m = without_small_loops(room_with_loop(0.2), 0.1);
  EXPECT_EQ(rest_m.size(), 5U);
  EXPECT_TRUE(geometry::touching_sides({rest_m}).empty());
  EXPECT_EQ(rest_m.front(), Eigen::Vector2d(0, 0));
}

TEST(RingLoops, StayWhereTheyAreLarge) {
  EXPECT_EQ(without_small_loops(room_with_loop(1.0), 0.1), room_with_loop(1.0));
}

TEST(RingLoops, AreCutOffBesideALargeOne) {
  const Polygon ring_m{
      {0, 0}, {2, 0}, {3, 1}, {3, 0}, {2, 1}, {1.2, 1}, {1.0, 1.2}, {1.2, 1.2}, {1.0, 1}, {0, 1}};
  ASSERT_EQ(geometry::touching_sides({ring_m}).size(), 2U);
  const Polygon rest_m = without_small_loops(ring_m, 0.1);
  EXPECT_EQ(geometry::touching_sides({rest_m}).size(), 1U) << "the large one";
  EXPECT_EQ(rest_m[3], Eigen::Vector2d(3, 0));
}

TEST(RingLoops, LeaveOtherRingsButTheirStraightCorners) {
  EXPECT_EQ(without_small_loops({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {0, 1}}, 0.1),
            (Polygon{{0, 0}, {2, 0}, {2, 1}, {0, 1}}));
  EXPECT_TRUE(without_small_loops({}, 0.1).empty());
}

}  // namespace
}  // namespace echomap::mapping
