// SPDX-License-Identifier: MIT
#include "host/mapping/tile_kernel.hpp"

#include <cstddef>
#include <cstring>

#include "host/mapping/vector_clones.hpp"

namespace echomap::mapping {

namespace {

using Bytes = std::uint8_t __attribute__((vector_size(kTileSide)));
using Words = std::uint64_t __attribute__((vector_size(kTileSide)));

/// For each bit of a word a byte that is not 0 where the bit is set, the lowest bit first.
[[gnu::always_inline]] inline void spread_bits(std::uint64_t bits, Bytes& bytes) {
  constexpr Words kPlaces = {0, 8, 16, 24, 32, 40, 48, 56};
  constexpr std::uint64_t kEightTimes = 0x0101010101010101U;
  constexpr std::uint64_t kBitOfByte = 0x8040201008040201U;
  const Words words = (((Words{} + bits) >> kPlaces) & 255U) * kEightTimes & kBitOfByte;
  std::memcpy(&bytes, &words, sizeof bytes);
}

/// after_evidence for a row of a tile.
[[gnu::always_inline]] inline void add_steps(const Bytes& steps_up,
                                             const Bytes& steps_down,
                                             EvidenceLimits limits,
                                             Bytes& cells) {
  const Bytes floor = steps_down + limits.lowest;
  const Bytes ceiling = limits.highest - steps_up;
  Bytes now = cells == kUntouchedByte ? Bytes{} + kEvenByte : cells;
  now = (now > floor ? now : floor) - steps_down;
  cells = (now < ceiling ? now : ceiling) + steps_up;
}

}  // namespace

ECHOMAP_VECTOR_CLONES
void add_scan(const TileBits& passed,
              const TileBits& hit,
              StepPair steps,
              EvidenceLimits limits,
              GridTile& tile) {
  for (std::int32_t y = 0; y < kTileSide; ++y) {
    const std::uint64_t hits = hit[static_cast<std::size_t>(y)];
    const std::uint64_t passes = passed[static_cast<std::size_t>(y)] & ~hits;
    if ((passes | hits) == 0) {
      continue;
    }
    Bytes before;
    Bytes is_passed;
    std::memcpy(&before, tile.row(y), sizeof before);
    spread_bits(passes, is_passed);
    Bytes after = before;
    add_steps(Bytes{}, Bytes{} + steps.down, limits, after);
    after = is_passed != 0 ? after : before;
    if (hits != 0) {
      Bytes raised = before;
      Bytes is_hit;
      spread_bits(hits, is_hit);
      add_steps(Bytes{} + steps.up, Bytes{}, limits, raised);
      after = is_hit != 0 ? raised : after;
    }
    std::memcpy(tile.row(y), &after, sizeof after);
  }
}

/// Squares of 32, 16 .. 1 bits change places (Warren 2012, section 7-3).
ECHOMAP_VECTOR_CLONES
void transpose(TileBits& bits) {
  std::uint64_t* const words = bits.data();
  std::uint64_t mask = 0x00000000FFFFFFFFU;
  for (std::size_t side = kTileSide / 2; side != 0; side >>= 1, mask ^= mask << side) {
    for (std::size_t block = 0; block < kTileSide; block += 2 * side) {
      for (std::size_t i = block; i < block + side; ++i) {
        const std::uint64_t swapped = ((words[i] >> side) ^ words[i + side]) & mask;
        words[i] ^= swapped << side;
        words[i + side] ^= swapped;
      }
    }
  }
}

}  // namespace echomap::mapping
