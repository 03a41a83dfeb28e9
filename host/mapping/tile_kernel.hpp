// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

#include "host/mapping/grid_tile.hpp"

namespace echomap::mapping {

/// One bit a cell: the rows of a tile as words, the lowest bit the first column.
using TileBits = std::array<std::uint64_t, kTileSide>;

/// Gives the same free evidence to all marked cells of a tile, `down` not 0.
void add_free(const TileBits& marked, std::uint8_t down, EvidenceLimits limits, GridTile& tile);

/// Gives the same occupied evidence to all marked cells of a tile, `up` not 0; quick where they are
/// few.
void add_hits(const TileBits& marked, std::uint8_t up, EvidenceLimits limits, GridTile& tile);

/// Turns bit j of word i into bit i of word j.
void transpose(TileBits& bits);

}  // namespace echomap::mapping
