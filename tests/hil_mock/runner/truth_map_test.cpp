// SPDX-License-Identifier: MIT
#include "hil_mock/runner/truth_map.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/hil_mock/world/rooms.hpp"

namespace echomap::runner {
namespace {

std::vector<std::string> drawn(const TruthMap& map) {
  std::vector<std::string> rows;
  for (int row = map.height - 1; row >= 0; --row) {
    std::string text;
    for (int column = 0; column < map.width; ++column) {
      const TruthCell cell = map.at(column, row);
      text += cell == TruthCell::kFree ? '.' : cell == TruthCell::kOccupied ? '#' : ' ';
    }
    rows.push_back(text);
  }
  return rows;
}

// A room of 2 x 1.2 m in cells of 0.2 m: walls run through the middle of cells. The box on the
// right closes off a chamber that the start cannot reach.
TEST(TruthMap, IsTheRoomAsDrawn) {
  const world::FloorPlan plan("drawn",
                              {world::rectangle(0.0, 0.0, 2.0, 1.2), {}},
                              {{world::rectangle(1.2, 0.0, 1.4, 1.2), {}}},
                              {0.5, 0.5, 0.0});
  const std::vector<std::string> expected = {
      "###########",
      "#.....##  #",
      "#.....##  #",
      "#.....##  #",
      "#.....##  #",
      "#.....##  #",
      "###########",
  };
  const TruthMap map = draw_truth_map(plan, 0.2);
  EXPECT_EQ(drawn(map), expected);
  EXPECT_DOUBLE_EQ(map.origin_x_m, -0.1);
}

// The middle of the floor is gone: its edge is no wall, and what is behind it cannot be reached.
TEST(TruthMap, AHoleIsNotFree) {
  const world::FloorPlan plan("drawn",
                              {world::rectangle(0.0, 0.0, 2.0, 1.2), {}},
                              {},
                              {0.3, 0.5, 0.0},
                              {{world::rectangle(0.5, 0.0, 1.3, 1.2)}, {}});
  const std::vector<std::string> expected = {
      "###########",
      "#..       #",
      "#..       #",
      "#..       #",
      "#..       #",
      "#..       #",
      "###########",
  };
  EXPECT_EQ(drawn(draw_truth_map(plan, 0.2)), expected);
}

// What is behind a box was floor before it came, and so is what it does not cover. The start may be
// below it by now.
TEST(TruthMap, ABoxCoversFloor) {
  world::FloorPlan plan("drawn", {world::rectangle(0.0, 0.0, 2.0, 1.2), {}}, {}, {1.1, 0.5, 0.0});
  plan.put_box({world::rectangle(0.8, -0.2, 1.4, 0.8), {}});
  const std::vector<std::string> expected = {
      "###########",
      "#.........#",
      "#...####..#",
      "#...#  #..#",
      "#...#  #..#",
      "#...#  #..#",
      "###########",
  };
  EXPECT_EQ(drawn(draw_truth_map(plan, 0.2)), expected);
}

TEST(TruthMap, FreeAreaIsThatOfTheRoom) {
  const world::FloorPlan plan = world::box_room({{world::rectangle(1.0, 1.0, 1.5, 2.0), {}}});
  const TruthMap map = draw_truth_map(plan, 0.01);
  int free = 0;
  for (const TruthCell cell : map.cells) {
    free += cell == TruthCell::kFree ? 1 : 0;
  }
  EXPECT_NEAR(free * 1e-4, 12.0 - 0.5, 0.2);
}

}  // namespace
}  // namespace echomap::runner
