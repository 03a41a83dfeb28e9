// SPDX-License-Identifier: MIT
#include "host/mapping/outline_sides.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "host/mapping/raster_outline.hpp"
#include "tests/host/mapping/outlines.hpp"

namespace echomap::mapping {
namespace {

using geometry::CellIndex;
using geometry::Polygon;
using geometry::Segment;

const Polygon kHallM{{0, 0}, {1, 0}, {1, 0.8}, {0, 0.8}};

/// A hall of 20 x 16 cells of 5 cm, walls around it.
RasterMap hall() {
  RasterMap map(22, 18, 0.05, {-0.05, -0.05});
  for (int y = 0; y < 18; ++y) {
    for (int x = 0; x < 22; ++x) {
      const bool is_wall = x == 0 || x == 21 || y == 0 || y == 17;
      map.set({x, y}, is_wall ? CellState::kOccupied : CellState::kFree);
    }
  }
  return map;
}

/// The hall with this state in the cells from `low` to, but without, `high`, counted from its
/// lower left corner.
RasterMap hall_with(CellState state, CellIndex low, CellIndex high) {
  RasterMap map = hall();
  for (int y = low.y; y < high.y; ++y) {
    for (int x = low.x; x < high.x; ++x) {
      map.set({x + 1, y + 1}, state);
    }
  }
  return map;
}

Polygon straightened(const RasterMap& map,
                     const std::vector<Segment>& walls,
                     const OutlineSideParams& params = {}) {
  return straight_outline(free_floor_rings(map).front(), map, walls, params);
}

/// Whether two neighbouring corners have that y.
bool has_side_at_y(const Polygon& outline_m, double y_m) {
  return std::count_if(outline_m.begin(), outline_m.end(), [&](const Eigen::Vector2d& corner_m) {
           return std::abs(corner_m.y() - y_m) < 1e-9;
         }) == 2;
}

TEST(StraightOutline, OfABorderIsItsSides) {
  const Polygon outline_m = straightened(hall(), {});
  EXPECT_EQ(outline_m.size(), 4U);
  EXPECT_LT(max_corner_error_m(kHallM, outline_m), 0.005);
  EXPECT_GT(geometry::signed_area_m2(outline_m), 0.0);
}

TEST(StraightOutline, HasTheLineOfAWallThatTheBorderFollows) {
  EXPECT_TRUE(has_side_at_y(straightened(hall(), {{{0.1, 0.03}, {0.9, 0.03}}}), 0.03));
}

TEST(StraightOutline, FollowsNoWallThatIsFarOrHasItsFloorBehindIt) {
  const auto is_hall = [](const std::vector<Segment>& walls) {
    const Polygon outline_m = straightened(hall(), walls);
    return outline_m.size() == 4 && max_corner_error_m(kHallM, outline_m) < 0.005;
  };
  EXPECT_TRUE(is_hall({{{0.1, 0.2}, {0.9, 0.2}}})) << "across";
  EXPECT_TRUE(is_hall({{{-3, 0.03}, {-2, 0.03}}})) << "along";
  EXPECT_TRUE(is_hall({{{0.9, 0.03}, {0.1, 0.03}}})) << "seen from behind";
}

TEST(StraightOutline, FollowsAWallWhoseBorderIsRagged) {
  RasterMap map = hall();
  for (int x = 2; x < 20; x += 4) {
    for (const CellIndex cell : {CellIndex{x, 0}, {x + 1, 0}, {x, 1}, {x + 1, 1}}) {
      map.set({cell.x + 1, cell.y + 1}, CellState::kOccupied);
    }
  }
  const Polygon outline_m = straightened(map, {{{0.2, 0.05}, {0.8, 0.05}}});
  EXPECT_EQ(outline_m.size(), 4U);
  EXPECT_TRUE(has_side_at_y(outline_m, 0.05));
}

TEST(StraightOutline, LeavesOutDetailAndKeepsWhatIsLarger) {
  const RasterMap shallow = hall_with(CellState::kOccupied, {8, 0}, {12, 1});
  EXPECT_EQ(straightened(shallow, {}).size(), 4U);
  const RasterMap deep = hall_with(CellState::kOccupied, {6, 0}, {14, 6});
  const std::vector<Segment> walls{{{0, 0}, {0.25, 0}}, {{0.75, 0}, {1, 0}}};
  const Polygon outline_m = straightened(deep, walls);
  EXPECT_EQ(outline_m.size(), 8U);
  EXPECT_LT(max_corner_error_m({{0.3, 0}, {0.3, 0.3}, {0.7, 0.3}, {0.7, 0}}, outline_m), 0.04);
  OutlineSideParams coarse;
  coarse.sequence.corner_cost_m = 0.25;
  EXPECT_EQ(straightened(deep, walls, coarse).size(), 4U);
}

TEST(StraightOutline, BridgesTheUnknownBetweenWallsOnly) {
  const std::vector<Segment> walls{{{1, 0}, {1, 0.4}}, {{0.6, 0.8}, {0, 0.8}}};
  const CellIndex low{12, 8};
  const CellIndex high{20, 16};
  const RasterMap unknown = hall_with(CellState::kUnknown, low, high);
  const Polygon outline_m = straightened(unknown, walls);
  EXPECT_EQ(outline_m.size(), 4U);
  EXPECT_LT(max_corner_error_m({{1, 0.8}}, outline_m), 1e-9);
  EXPECT_EQ(straightened(hall_with(CellState::kOccupied, low, high), walls).size(), 6U);
  OutlineSideParams params;
  params.lines.bridged_m = 0.1;
  EXPECT_EQ(straightened(unknown, walls, params).size(), 6U);
}

TEST(StraightOutline, PassesOverAWallThatIsDrawnBeyondItsCorner) {
  // The hall less its upper right quarter; the wall below that goes on into the hall.
  RasterMap map = hall_with(CellState::kUnknown, {10, 8}, {20, 16});
  for (int x = 4; x < 20; ++x) {
    map.set({x + 1, 9}, CellState::kOccupied);
  }
  const std::vector<Segment> walls{{{0.95, 0.4}, {0.2, 0.4}}, {{0.5, 0.42}, {0.5, 0.8}}};
  const Polygon outline_m = straightened(map, walls);
  EXPECT_EQ(outline_m.size(), 6U);
  EXPECT_LT(max_corner_error_m({{1, 0}, {1, 0.4}, {0.5, 0.4}, {0.5, 0.8}}, outline_m), 0.02);
}

TEST(StraightOutline, OfNothingHasNoCorners) {
  EXPECT_TRUE(straight_outline({}, hall(), {}, {}).empty());
}

}  // namespace
}  // namespace echomap::mapping
