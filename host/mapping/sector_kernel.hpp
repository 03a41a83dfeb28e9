// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "host/mapping/cone_sector.hpp"
#include "host/mapping/grid_tile.hpp"

namespace echomap::mapping {

/// Neighbouring rows of a sector that are cut to a ring: in each row stay the columns at most
/// `outer`, and more than `inner`, away from the apex; -1 leaves none, or cuts none out.
struct RingRows {
  std::span<const SectorRow> rows;
  std::span<const std::int16_t> outer;
  std::span<const std::int16_t> inner;
  const std::uint8_t* steps = nullptr;  ///< Of the whole sector.

  /// At most `count` of the rows, without the first `skipped` ones.
  RingRows rows_from(std::size_t skipped, std::size_t count) const {
    const std::size_t left = std::min(count, rows.size() - skipped);
    return {rows.subspan(skipped, left),
            outer.subspan(skipped, left),
            inner.subspan(skipped, left),
            steps};
  }
};

/// Where the first of the rows and the apex stand in a tile; the apex may be outside of it.
struct RingPlace {
  std::int32_t first_row = 0;
  std::int32_t apex_column = 0;
};

/// The rectangle around the cells of a tile that a kernel has touched.
struct TouchedCells {
  std::int32_t first_row = kTileSide;
  std::int32_t last_row = -1;
  std::int32_t first_column = kTileSide;
  std::int32_t last_column = -1;
};

/// For rows `first_y`, `first_y` + 1 ..: how many columns off the middle a cell's distance squared
/// is still at most `square`; -1 where none is. `square` below 2^22.
void half_widths(std::int32_t square, std::int32_t first_y, std::span<std::int16_t> widths);

/// Whether the ring has a cell in the tile; a ring without a hole has -1 in all of `inner`.
bool reaches(const RingRows& ring, const RingPlace& place);

/// Adds the steps of free floor, or of an arc, to a tile's cells.
TouchedCells add_floor(const RingRows& ring,
                       const RingPlace& place,
                       EvidenceLimits limits,
                       GridTile& tile);
TouchedCells add_arc(const RingRows& ring,
                     const RingPlace& place,
                     EvidenceLimits limits,
                     GridTile& tile);

}  // namespace echomap::mapping
