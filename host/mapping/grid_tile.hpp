// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace echomap::mapping {

/// The edge of a tile in cells: one row of a tile is one cache line, or the bits of one word.
constexpr int kTileBits = 6;
constexpr std::int32_t kTileSide = 1 << kTileBits;

/// What a byte of the grid says: 0 that no evidence has ever fallen, else kEvenByte plus the
/// log-odds in steps.
constexpr std::uint8_t kUntouchedByte = 0;
constexpr std::uint8_t kEvenByte = 128;

/// One tile's cells, row by row upwards.
struct alignas(64) GridTile {
  std::array<std::uint8_t, std::size_t{kTileSide} * kTileSide> cells{};

  std::uint8_t* row(std::int32_t y) { return &cells[static_cast<std::size_t>(y) << kTileBits]; }
  const std::uint8_t* row(std::int32_t y) const {
    return &cells[static_cast<std::size_t>(y) << kTileBits];
  }
};

/// Evidence for one cell as two unsigned bytes, one of them 0: steps towards occupied and towards
/// free.
struct StepPair {
  std::uint8_t up = 0;
  std::uint8_t down = 0;
};

/// The lowest and the highest byte that evidence can make of a cell.
struct EvidenceLimits {
  std::uint8_t lowest = 1;
  std::uint8_t highest = 255;
};

/// A cell's byte after evidence that is not zero. Only unsigned minima, maxima and sums, which
/// every vector unit has for bytes.
inline std::uint8_t after_evidence(std::uint8_t byte, StepPair steps, EvidenceLimits limits) {
  const auto floor = static_cast<std::uint8_t>(limits.lowest + steps.down);
  const auto ceiling = static_cast<std::uint8_t>(limits.highest - steps.up);
  const std::uint8_t known = byte == kUntouchedByte ? kEvenByte : byte;
  const auto lowered = static_cast<std::uint8_t>(std::max(known, floor) - steps.down);
  return static_cast<std::uint8_t>(std::min(lowered, ceiling) + steps.up);
}

}  // namespace echomap::mapping
