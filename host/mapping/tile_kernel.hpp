// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

#include "host/mapping/grid_tile.hpp"

namespace echomap::mapping {

/// One bit a cell: the rows of a tile as words, the lowest bit the first column.
using TileBits = std::array<std::uint64_t, kTileSide>;

/// Gives the cells of a tile that were hit `steps.up`, and those that were only passed
/// `steps.down`; neither is 0.
void add_scan(const TileBits& passed,
              const TileBits& hit,
              StepPair steps,
              EvidenceLimits limits,
              GridTile& tile);

/// Turns bit j of word i into bit i of word j.
void transpose(TileBits& bits);

}  // namespace echomap::mapping
