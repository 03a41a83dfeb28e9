// SPDX-License-Identifier: MIT
#include "host/mapping/tile_index.hpp"

#include <map>
#include <random>

#include <gtest/gtest.h>

namespace echomap::mapping {
namespace {

using geometry::CellIndex;

TEST(TileIndex, FindsNothingInItselfAtFirst) {
  EXPECT_EQ(TileIndex().find({0, 0}), TileIndex::kNone);
}

TEST(TileIndex, FindsWhatAMapFinds) {
  std::mt19937 random(5);
  const auto coordinate = [&] { return static_cast<std::int32_t>(random() % 60) - 30; };
  std::map<CellIndex, std::int32_t> expected;
  TileIndex index;
  for (std::int32_t number = 0; number < 1500; ++number) {
    const CellIndex tile{coordinate(), coordinate()};
    if (expected.emplace(tile, number).second) {
      index.insert(tile, number);
    }
  }
  for (std::int32_t y = -40; y < 40; ++y) {
    for (std::int32_t x = -40; x < 40; ++x) {
      const auto found = expected.find({x, y});
      ASSERT_EQ(index.find({x, y}), found == expected.end() ? TileIndex::kNone : found->second)
          << x << ' ' << y;
    }
  }
}

TEST(TileIndex, GrowsWithTheTilesNotWithTheGroundBetweenThem) {
  TileIndex index;
  index.insert({-2'000'000'000, 2'000'000'000}, 0);
  index.insert({2'000'000'000, -2'000'000'000}, 1);
  EXPECT_LT(index.memory_bytes(), 1000U);
  EXPECT_EQ(index.find({2'000'000'000, -2'000'000'000}), 1);
}

TEST(TileIndex, ForgetsAllButItsMemory) {
  TileIndex index;
  for (std::int32_t number = 0; number < 100; ++number) {
    index.insert({number, 0}, number);
  }
  const std::size_t bytes = index.memory_bytes();
  index.clear();
  EXPECT_EQ(index.find({7, 0}), TileIndex::kNone);
  index.insert({7, 0}, 3);
  EXPECT_EQ(index.find({7, 0}), 3);
  EXPECT_EQ(index.memory_bytes(), bytes);
}

}  // namespace
}  // namespace echomap::mapping
