// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "host/mapping/grid_tile.hpp"
#include "host/mapping/sector_rows.hpp"

namespace echomap::mapping {

/// The most wedges of a sector.
constexpr std::size_t kMostWedges = 8;

/// What wedges add to the evidence, each as a step: bytes of 0, and from its middle on of what the
/// wedge adds. Read from the middle less a column on, these are 0 before this column; less what is
/// read for the column after the wedge's last one they are what the wedge adds to a row.
class WedgeSteps {
 public:
  /// For sectors that reach so far. Sums of `heights` may wrap around.
  WedgeSteps(std::span<const std::uint8_t> heights, std::int32_t reach_cells);

  std::size_t wedges() const { return wedges_; }
  /// The step of a wedge as of a column that is seen from the apex.
  const std::uint8_t* wedge(std::size_t number, std::int32_t column) const {
    return &bytes_[(2 * number + 1) * half_] + column;
  }
  /// The same, all bits set, for what is to be cut out.
  const std::uint8_t* hole(std::int32_t column) const { return wedge(wedges_, column); }

 private:
  std::size_t wedges_;
  std::size_t half_;
  std::vector<std::uint8_t> bytes_;
};

/// Half a tile's row is one vector of most processors, and more than most rows of a cone.
constexpr int kPatchBits = 5;
constexpr std::int32_t kPatchSide = 1 << kPatchBits;

/// kPatchSide columns and some rows within one tile, as seen from the apex.
struct Patch {
  std::int32_t first_column = 0;
  Stretch rows;
};

/// Adds the free floor, or the arc, of a sector to a patch, of which `cells` is the first; its rows
/// are kTileSide apart and within the sector's bounds.
void add_floor(const SectorRows& rows,
               const WedgeSteps& steps,
               const Patch& patch,
               EvidenceLimits limits,
               std::uint8_t* cells);
void add_arc(const SectorRows& rows,
             const WedgeSteps& steps,
             const Patch& patch,
             EvidenceLimits limits,
             std::uint8_t* cells);

}  // namespace echomap::mapping
