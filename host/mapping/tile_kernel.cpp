// SPDX-License-Identifier: MIT
#include "host/mapping/tile_kernel.hpp"

#include <bit>
#include <cstddef>
#include <cstring>

#include "host/mapping/vector_clones.hpp"

namespace echomap::mapping {

namespace {

/// For each byte eight bytes, 255 for a bit that is set, the lowest bit first.
constexpr std::array<std::array<std::uint8_t, 8>, 256> kSpread = [] {
  std::array<std::array<std::uint8_t, 8>, 256> spread{};
  for (std::size_t byte = 0; byte < spread.size(); ++byte) {
    for (std::size_t bit = 0; bit < 8; ++bit) {
      spread[byte][bit] = (byte >> bit) & 1U ? 255 : 0;
    }
  }
  return spread;
}();

void spread_bits(const TileBits& marked, std::uint8_t* bytes) {
  for (const std::uint64_t row : marked) {
    for (int byte = 0; byte < 8; ++byte, bytes += 8) {
      std::memcpy(bytes, kSpread[(row >> (8 * byte)) & 255U].data(), 8);
    }
  }
}

}  // namespace

ECHOMAP_VECTOR_CLONES
void add_free(const TileBits& marked, std::uint8_t down, EvidenceLimits limits, GridTile& tile) {
  alignas(64) std::uint8_t mask[sizeof(GridTile::cells)];
  spread_bits(marked, mask);
  std::uint8_t* const cells = tile.cells.data();
  for (std::size_t i = 0; i < sizeof mask; ++i) {
    const std::uint8_t after = after_evidence(cells[i], {0, down}, limits);
    cells[i] = static_cast<std::uint8_t>((after & mask[i]) | (cells[i] & ~mask[i]));
  }
}

void add_hits(const TileBits& marked, std::uint8_t up, EvidenceLimits limits, GridTile& tile) {
  for (std::int32_t y = 0; y < kTileSide; ++y) {
    for (std::uint64_t left = marked[static_cast<std::size_t>(y)]; left != 0; left &= left - 1) {
      std::uint8_t& byte = tile.row(y)[std::countr_zero(left)];
      byte = after_evidence(byte, {up, 0}, limits);
    }
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
