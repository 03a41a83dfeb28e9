// SPDX-License-Identifier: MIT
#include "host/mapping/floor_border.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "host/mapping/raster_outline.hpp"
#include "tests/host/mapping/outlines.hpp"
#include "tests/support/drawn_map.hpp"

namespace echomap::mapping {
namespace {

using tests::map_from;

TEST(FloorBorder, HasAPointForEveryEdgeOfACell) {
  const RasterMap map = map_from({"#####", "#...#", "#...#", "#####"});
  const auto border = border_of(map);
  ASSERT_EQ(border.size(), 10U);
  for (std::size_t i = 0; i < border.size(); ++i) {
    EXPECT_TRUE(border[i].is_occupied) << i;
    EXPECT_NEAR((joint_m(border, i) - border[i].position_m).norm(), 0.5 * map.resolution_m(), 0.02);
  }
}

TEST(FloorBorder, KnowsWhereTheUnknownBegins) {
  const RasterMap map = map_from({"     ", "  ...", "  ...", "#####"});
  const auto border = border_of(map);
  const auto occupied = std::count_if(
      border.begin(), border.end(), [](const BorderPoint& point) { return point.is_occupied; });
  EXPECT_EQ(occupied, 3);
}

TEST(FloorBorder, PointsOutOfTheFloorEvenWhereItIsAStaircase) {
  const RasterMap map =
      map_from({"......#", ".....# ", "....#  ", "...#   ", "..#    ", ".#     ", "#      "});
  int in_the_middle = 0;
  for (const BorderPoint& point : border_of(map)) {
    if (point.is_occupied && (point.position_m - map.center_m({3, 3})).norm() < 0.1) {
      ++in_the_middle;
      EXPECT_GT(point.outward.dot(Eigen::Vector2d(1, -1).normalized()), 0.5);
    }
  }
  EXPECT_GT(in_the_middle, 2);
}

TEST(FloorBorder, LooksThroughTheUnknownUpToAWall) {
  const RasterMap map = map_from({"..    #..", "..    ...", "..       "});
  const double cell_m = map.resolution_m();
  const auto at = [&](int x, int y) { return map.center_m({x, y}); };
  EXPECT_TRUE(is_unknown_up_to(map, at(1, 2), at(6, 2), cell_m)) << "to the wall";
  EXPECT_FALSE(is_unknown_up_to(map, at(1, 2), at(6, 2), 0.0)) << "into it";
  EXPECT_FALSE(is_unknown_up_to(map, at(1, 1), at(8, 1), cell_m)) << "over floor";
  EXPECT_TRUE(is_unknown_up_to(map, at(1, 0), at(8, 0), 0.0));
}

}  // namespace
}  // namespace echomap::mapping
