// SPDX-License-Identifier: MIT
#include "host/exploration/frontier_search.hpp"

#include <algorithm>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "tests/support/drawn_map.hpp"

namespace echomap::exploration {
namespace {

using geometry::CellIndex;
using mapping::CellState;
using mapping::RasterMap;

RasterMap random_states(std::uint32_t seed) {
  std::mt19937 random(seed);
  RasterMap map(25, 19, 0.05, {0.0, 0.0});
  for (int y = 0; y < map.rows(); ++y) {
    for (int x = 0; x < map.columns(); ++x) {
      const auto dice = random() % 10;
      map.set({x, y},
              dice < 6   ? CellState::kFree
              : dice < 8 ? CellState::kOccupied
                         : CellState::kUnknown);
    }
  }
  return map;
}

bool touches_unknown(const RasterMap& map, CellIndex cell) {
  return map.state({cell.x + 1, cell.y}) == CellState::kUnknown ||
         map.state({cell.x - 1, cell.y}) == CellState::kUnknown ||
         map.state({cell.x, cell.y + 1}) == CellState::kUnknown ||
         map.state({cell.x, cell.y - 1}) == CellState::kUnknown;
}

/// Free floor joined to `from`, by growing a set until it does not grow.
std::set<CellIndex> joined_floor(const RasterMap& map, CellIndex from) {
  std::set<CellIndex> floor{from};
  for (std::size_t before = 0; before != floor.size();) {
    before = floor.size();
    for (const CellIndex cell : std::set<CellIndex>(floor)) {
      for (const CellIndex by : {CellIndex{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
        const CellIndex next{cell.x + by.x, cell.y + by.y};
        if (map.state(next) == CellState::kFree) {
          floor.insert(next);
        }
      }
    }
  }
  return floor;
}

TEST(FrontierSearch, FindsEveryFrontierCellOnceAndNoOther) {
  for (std::uint32_t seed = 1; seed <= 30; ++seed) {
    RasterMap map = random_states(seed);
    const CellIndex from{12, 9};
    map.set(from, CellState::kFree);
    std::multiset<CellIndex> found;
    for (const auto& frontier : find_frontiers(map, from)) {
      found.insert(frontier.begin(), frontier.end());
    }
    std::multiset<CellIndex> expected;
    for (const CellIndex cell : joined_floor(map, from)) {
      if (touches_unknown(map, cell)) {
        expected.insert(cell);
      }
    }
    EXPECT_EQ(found, expected) << "seed " << seed;
  }
}

TEST(FrontierSearch, CellsOfOneFrontierHangTogetherAndThoseOfTwoDoNot) {
  const auto touch = [](CellIndex a, CellIndex b) {
    return std::max(std::abs(a.x - b.x), std::abs(a.y - b.y)) <= 1;
  };
  for (std::uint32_t seed = 1; seed <= 30; ++seed) {
    RasterMap map = random_states(seed);
    map.set({12, 9}, CellState::kFree);
    const auto frontiers = find_frontiers(map, {12, 9});
    for (std::size_t i = 0; i < frontiers.size(); ++i) {
      for (const CellIndex cell : frontiers[i]) {
        const auto is_beside = [&](CellIndex other) { return other != cell && touch(cell, other); };
        EXPECT_TRUE(frontiers[i].size() == 1 ||
                    std::any_of(frontiers[i].begin(), frontiers[i].end(), is_beside));
        for (std::size_t j = i + 1; j < frontiers.size(); ++j) {
          EXPECT_TRUE(std::none_of(frontiers[j].begin(), frontiers[j].end(), is_beside));
        }
      }
    }
  }
}

TEST(FrontierSearch, TheLargestFrontierComesFirst) {
  const auto map = tests::map_from({
      "#########",
      "#.......#",
      "#       #",
      "#########",
      "#.......#",
      "#.#######",
      "#.. #####",
      "#########",
  });
  const auto frontiers = find_frontiers(map, {1, 1});
  ASSERT_EQ(frontiers.size(), 1U) << "the upper floor is not joined";
  EXPECT_EQ(frontiers.front(), (FrontierCells{{2, 1}}));
  EXPECT_EQ(find_frontiers(map, {3, 6}).front().size(), 7U);
}

TEST(FrontierSearch, AClosedRoomHasNone) {
  EXPECT_TRUE(find_frontiers(tests::map_from({"####", "#..#", "####"}), {1, 1}).empty());
}

TEST(FrontierSearch, TheEdgeOfTheMapIsAFrontier) {
  EXPECT_EQ(find_frontiers(tests::map_from({"...", "...", "..."}), {1, 1}).front().size(), 8U);
}

TEST(FrontierSearch, FindsNoneFromUnknownFloorAWallOrOutside) {
  const auto map = tests::map_from({"# .", "...", "..."});
  EXPECT_TRUE(find_frontiers(map, {0, 2}).empty());
  EXPECT_TRUE(find_frontiers(map, {1, 2}).empty());
  EXPECT_TRUE(find_frontiers(map, {9, 9}).empty());
}

}  // namespace
}  // namespace echomap::exploration
