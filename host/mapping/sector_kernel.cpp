// SPDX-License-Identifier: MIT
#include "host/mapping/sector_kernel.hpp"

#include <array>
#include <utility>

#include "host/mapping/vector_clones.hpp"

namespace echomap::mapping {

namespace {

enum class Kind : std::uint8_t { kFloor, kArc, kArcWithHole };

/// Where a step is read for one row of a patch.
struct StepReads {
  const std::uint8_t* risen;
  const std::uint8_t* fallen;

  std::uint8_t at(std::size_t x) const { return static_cast<std::uint8_t>(risen[x] - fallen[x]); }
};

[[gnu::always_inline]] inline StepReads reads(const std::uint8_t* step,
                                              const RowColumns& columns,
                                              std::ptrdiff_t row) {
  return {step + columns.minus_from[row], step + columns.minus_to[row]};
}

/// The steps are nowhere in the tile, so that no cell hangs on what another one becomes.
template <Kind kKind, std::size_t... kNumbers>
[[gnu::always_inline]] inline void add_row(const std::array<StepReads, sizeof...(kNumbers)>& wedges,
                                           const StepReads& hole,
                                           EvidenceLimits limits,
                                           std::uint8_t* cells,
                                           std::index_sequence<kNumbers...> /*numbers*/) {
#pragma GCC ivdep
  for (std::size_t x = 0; x < kPatchSide; ++x) {
    auto steps = static_cast<std::uint8_t>((... + wedges[kNumbers].at(x)));
    if constexpr (kKind == Kind::kArcWithHole) {
      steps = static_cast<std::uint8_t>(steps & ~hole.at(x));
    }
    const StepPair pair = kKind == Kind::kFloor ? StepPair{0, steps} : StepPair{steps, 0};
    const std::uint8_t after = after_evidence(cells[x], pair, limits);
    cells[x] = steps == 0 ? cells[x] : after;
  }
}

template <Kind kKind, std::size_t kWedges>
[[gnu::always_inline]] inline void add_rows(const SectorRows& rows,
                                            const WedgeSteps& steps,
                                            const Patch& patch,
                                            EvidenceLimits limits,
                                            std::uint8_t* cells) {
  std::array<const std::uint8_t*, kWedges> wedge_steps;
  std::array<RowColumns, kWedges> wedge_columns;
  for (std::size_t i = 0; i < kWedges; ++i) {
    wedge_steps[i] = steps.wedge(i, patch.first_column);
    wedge_columns[i] = rows.wedge(i, patch.rows.first);
  }
  const std::uint8_t* const hole_step = steps.hole(patch.first_column);
  const RowColumns hole_columns = rows.hole(patch.rows.first);
  for (std::ptrdiff_t row = 0; row <= patch.rows.last - patch.rows.first; ++row) {
    std::array<StepReads, kWedges> wedges;
    for (std::size_t i = 0; i < kWedges; ++i) {
      wedges[i] = reads(wedge_steps[i], wedge_columns[i], row);
    }
    StepReads hole{};
    if constexpr (kKind == Kind::kArcWithHole) {
      hole = reads(hole_step, hole_columns, row);
    }
    add_row<kKind>(wedges, hole, limits, cells, std::make_index_sequence<kWedges>());
    cells += kTileSide;
  }
}

/// With the number of wedges known to the compiler a row's steps stay in registers.
template <Kind kKind, std::size_t kWedges = 1>
[[gnu::always_inline]] inline void add_wedges(const SectorRows& rows,
                                              const WedgeSteps& steps,
                                              const Patch& patch,
                                              EvidenceLimits limits,
                                              std::uint8_t* cells) {
  if (steps.wedges() == kWedges) {
    add_rows<kKind, kWedges>(rows, steps, patch, limits, cells);
  } else if constexpr (kWedges < kMostWedges) {
    add_wedges<kKind, kWedges + 1>(rows, steps, patch, limits, cells);
  }
}

}  // namespace

WedgeSteps::WedgeSteps(std::span<const std::uint8_t> heights, std::int32_t reach_cells)
    : wedges_(heights.size()), half_(2 * static_cast<std::size_t>(reach_cells + kTileSide)) {
  for (std::size_t i = 0; i <= wedges_; ++i) {
    bytes_.insert(bytes_.end(), half_, 0);
    bytes_.insert(bytes_.end(), half_, i < wedges_ ? heights[i] : std::uint8_t{255});
  }
}

ECHOMAP_VECTOR_CLONES
void add_floor(const SectorRows& rows,
               const WedgeSteps& steps,
               const Patch& patch,
               EvidenceLimits limits,
               std::uint8_t* cells) {
  add_wedges<Kind::kFloor>(rows, steps, patch, limits, cells);
}

ECHOMAP_VECTOR_CLONES
void add_arc(const SectorRows& rows,
             const WedgeSteps& steps,
             const Patch& patch,
             EvidenceLimits limits,
             std::uint8_t* cells) {
  if (rows.has_hole()) {
    add_wedges<Kind::kArcWithHole>(rows, steps, patch, limits, cells);
  } else {
    add_wedges<Kind::kArc>(rows, steps, patch, limits, cells);
  }
}

}  // namespace echomap::mapping
