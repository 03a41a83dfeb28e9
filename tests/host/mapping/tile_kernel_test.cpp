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

TEST(TileKernel, GivesMarkedCellsTheEvidenceAndLeavesTheOthers) {
  std::mt19937 random(2);
  const TileBits bits = random_bits(random);
  const GridTile before = random_tile(random);
  GridTile freed = before;
  GridTile hit = before;
  add_free(bits, 8, kLimits, freed);
  add_hits(bits, 17, kLimits, hit);
  for (std::size_t i = 0; i < before.cells.size(); ++i) {
    const bool is_marked = (bits[i / kTileSide] >> (i % kTileSide)) & 1U;
    const std::uint8_t was = before.cells[i];
    ASSERT_EQ(freed.cells[i], is_marked ? after_evidence(was, {0, 8}, kLimits) : was) << i;
    ASSERT_EQ(hit.cells[i], is_marked ? after_evidence(was, {17, 0}, kLimits) : was) << i;
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
