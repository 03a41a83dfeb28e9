// SPDX-License-Identifier: MIT
#include "host/mapping/tile_kernel.hpp"

#include <random>

#include <gtest/gtest.h>

namespace echomap::mapping {
namespace {

constexpr EvidenceLimits kLimits{28, 228};

TileBits random_bits(std::mt19937& random) {
  TileBits bits{};
  for (std::uint64_t& row : bits) {
    row = (std::uint64_t{random()} << 32) | random();
  }
  return bits;
}

GridTile random_tile(std::mt19937& random) {
  GridTile tile;
  for (std::uint8_t& cell : tile.cells) {
    cell = random() % 4 == 0 ? kUntouchedByte : static_cast<std::uint8_t>(28 + random() % 201);
  }
  return tile;
}

TEST(TileKernel, RaisesHitCellsLowersPassedOnesAndLeavesTheOthers) {
  std::mt19937 random(2);
  const TileBits passed = random_bits(random);
  TileBits hit{};
  for (int i = 0; i < 60; ++i) {
    hit[random() % kTileSide] |= std::uint64_t{1} << (random() % kTileSide);
  }
  const GridTile before = random_tile(random);
  GridTile tile = before;
  add_scan(passed, hit, {17, 8}, kLimits, tile);
  for (std::size_t i = 0; i < before.cells.size(); ++i) {
    const bool is_hit = (hit[i / kTileSide] >> (i % kTileSide)) & 1U;
    const bool is_passed = (passed[i / kTileSide] >> (i % kTileSide)) & 1U;
    const StepPair steps = is_hit ? StepPair{17, 0} : StepPair{0, 8};
    const std::uint8_t was = before.cells[i];
    ASSERT_EQ(tile.cells[i], is_hit || is_passed ? after_evidence(was, steps, kLimits) : was) << i;
  }
}

TEST(TileKernel, TurnsRowsIntoColumns) {
  std::mt19937 random(4);
  const TileBits bits = random_bits(random);
  TileBits turned = bits;
  transpose(turned);
  for (std::size_t i = 0; i < kTileSide; ++i) {
    for (std::size_t j = 0; j < kTileSide; ++j) {
      ASSERT_EQ((turned[j] >> i) & 1U, (bits[i] >> j) & 1U) << i << ' ' << j;
    }
  }
}

}  // namespace
}  // namespace echomap::mapping
