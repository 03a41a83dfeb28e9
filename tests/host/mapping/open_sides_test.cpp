// SPDX-License-Identifier: MIT
#include "host/mapping/open_sides.hpp"

#include <gtest/gtest.h>

namespace echomap::mapping {
namespace {

const geometry::Polygon kOblongM{{0, 0}, {2, 0}, {2, 1}, {0, 1}};

/// Occupied cells along the wall below, from x = 0 to `to_m`.
RasterMap map_with_wall(double to_m) {
  RasterMap map(60, 40, 0.05, {-0.5, -0.5});
  for (int x = 10; x < 10 + static_cast<int>(to_m / 0.05); ++x) {
    map.set({x, 9}, CellState::kOccupied);
  }
  return map;
}

TEST(OpenSides, AreThoseWithoutAnyWall) {
  EXPECT_EQ(open_sides(kOblongM, map_with_wall(2.0), {}),
            (std::vector<bool>{false, true, true, true}));
  EXPECT_EQ(open_sides(kOblongM, map_with_wall(0.0), {{{{2, 0.1}, {2, 0.9}}}, {}}),
            (std::vector<bool>{true, false, true, true}));
}

TEST(OpenSides, HaveAWallOnLessThanHalfOfTheirLength) {
  EXPECT_FALSE(open_sides(kOblongM, map_with_wall(1.2), {})[0]);
  EXPECT_TRUE(open_sides(kOblongM, map_with_wall(0.7), {})[0]);
}

TEST(OpenSides, OfNoOutlineAreNone) { EXPECT_TRUE(open_sides({}, map_with_wall(1.0), {}).empty()); }

}  // namespace
}  // namespace echomap::mapping
