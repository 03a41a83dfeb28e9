// SPDX-License-Identifier: MIT
#include "host/mapping/sector_kernel.hpp"

#include <algorithm>
#include <cmath>

#include "host/mapping/vector_clones.hpp"

namespace echomap::mapping {

namespace {

enum class Kind : std::uint8_t { kFloor, kArc };

/// Columns of a tile from `from` to `to`, `to` not included.
struct Columns {
  std::int32_t from = 0;
  std::int32_t to = 0;
};

struct RowCells {
  Columns ring;
  Columns hole;
};

/// The cells of row `i` of the ring; of an empty row, `ring.to` is not after `ring.from`.
template <Kind kKind>
[[gnu::always_inline]] inline RowCells cells_of(const RingRows& ring,
                                                std::size_t i,
                                                std::int32_t apex_column) {
  const SectorRow row = ring.rows[i];
  const std::int32_t outer = ring.outer[i];
  Columns columns{std::max(std::max<std::int32_t>(row.first, -outer) + apex_column, 0),
                  std::min(std::min<std::int32_t>(row.last, outer) + apex_column + 1, kTileSide)};
  if constexpr (kKind == Kind::kFloor) {
    return {columns, {}};
  }
  const std::int32_t inner = ring.inner[i];
  if (inner < 0) {
    return {columns, {}};
  }
  const Columns hole{std::clamp(apex_column - inner, 0, kTileSide),
                     std::clamp(apex_column + inner + 1, 0, kTileSide)};
  columns.from = hole.from <= columns.from ? std::max(columns.from, hole.to) : columns.from;
  columns.to = hole.to >= columns.to ? std::min(columns.to, hole.from) : columns.to;
  return {columns, hole};
}

/// Adds the steps of a tile's row, of which column 0 is the first, where the ring has cells.
template <Kind kKind>
[[gnu::always_inline]] inline void add_row(std::uint8_t* __restrict cells,
                                           const std::uint8_t* __restrict all_steps,
                                           const RowCells& row,
                                           EvidenceLimits limits) {
  const auto from = static_cast<std::uint8_t>(row.ring.from);
  const auto width = static_cast<std::uint8_t>(row.ring.to - row.ring.from);
  const auto hole_from = static_cast<std::uint8_t>(row.hole.from);
  const auto hole_width = static_cast<std::uint8_t>(row.hole.to - row.hole.from);
  for (int i = 0; i < kTileSide; ++i) {
    const std::uint8_t is_in = static_cast<std::uint8_t>(i - from) < width ? 255 : 0;
    const std::uint8_t is_hole = static_cast<std::uint8_t>(i - hole_from) < hole_width ? 255 : 0;
    const auto steps =
        static_cast<std::uint8_t>(all_steps[i] & is_in & (kKind == Kind::kArc ? ~is_hole : 255));
    const StepPair pair = kKind == Kind::kFloor ? StepPair{0, steps} : StepPair{steps, 0};
    const std::uint8_t after = after_evidence(cells[i], pair, limits);
    cells[i] = steps == 0 ? cells[i] : after;
  }
}

template <Kind kKind>
[[gnu::always_inline]] inline TouchedCells add_rows(const RingRows& ring,
                                                    const RingPlace& place,
                                                    EvidenceLimits limits,
                                                    GridTile& tile) {
  TouchedCells touched;
  std::int32_t y = place.first_row;
  std::uint8_t* cells = tile.row(y);
  for (std::size_t i = 0; i < ring.rows.size(); ++i, ++y, cells += kTileSide) {
    const RowCells row = cells_of<kKind>(ring, i, place.apex_column);
    if (row.ring.to <= row.ring.from) {
      continue;
    }
    const std::int32_t first_column = ring.rows[i].first + place.apex_column;
    add_row<kKind>(cells, ring.steps + ring.rows[i].steps_begin - first_column, row, limits);
    touched = {std::min(touched.first_row, y),
               y,
               std::min(touched.first_column, row.ring.from),
               std::max(touched.last_column, row.ring.to - 1)};
  }
  return touched;
}

}  // namespace

ECHOMAP_VECTOR_CLONES
void half_widths(std::int32_t square, std::int32_t first_y, std::span<std::int16_t> widths) {
  const auto count = static_cast<std::int32_t>(widths.size());
  std::int16_t* const width = widths.data();
  for (std::int32_t i = 0; i < count; ++i) {
    const std::int32_t left = square - (first_y + i) * (first_y + i);
    const auto root = static_cast<std::int32_t>(std::sqrt(static_cast<float>(std::max(left, 0))));
    width[i] = static_cast<std::int16_t>(root - (left < 0 ? 1 : 0));
  }
}

bool reaches(const RingRows& ring, const RingPlace& place) {
  for (std::size_t i = 0; i < ring.rows.size(); ++i) {
    const RowCells row = cells_of<Kind::kArc>(ring, i, place.apex_column);
    if (row.ring.to > row.ring.from) {
      return true;
    }
  }
  return false;
}

ECHOMAP_AVX2_CLONES
TouchedCells add_floor(const RingRows& ring,
                       const RingPlace& place,
                       EvidenceLimits limits,
                       GridTile& tile) {
  return add_rows<Kind::kFloor>(ring, place, limits, tile);
}

ECHOMAP_AVX2_CLONES
TouchedCells add_arc(const RingRows& ring,
                     const RingPlace& place,
                     EvidenceLimits limits,
                     GridTile& tile) {
  return add_rows<Kind::kArc>(ring, place, limits, tile);
}

}  // namespace echomap::mapping
