// SPDX-License-Identifier: MIT
#include "host/mapping/cone_insertion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "host/geometry/angle.hpp"
#include "host/geometry/unit_vector.hpp"

namespace echomap::mapping {

namespace {

using geometry::CellIndex;

/// Asks for all of some memory at once; the sectors of all bearings do not fit into a near cache.
void prefetch(const void* begin, std::size_t bytes) {
  constexpr std::size_t kCacheLine = 64;
  for (std::size_t at = 0; at < bytes; at += kCacheLine) {
    __builtin_prefetch(static_cast<const char*>(begin) + at);
  }
}

struct Extent {
  std::int32_t first = 0;
  std::int32_t last = 0;
};

/// The cells along an axis that a ring can reach, with one to spare on either side.
Extent extent(const ShareRange& shares, std::int32_t hole, std::int32_t rim) {
  const double near = std::sqrt(std::max(hole, 0));
  const double far = std::sqrt(rim);
  const double least = shares.least * (shares.least < 0.0 ? far : near);
  const double greatest = shares.greatest * (shares.greatest > 0.0 ? far : near);
  return {static_cast<std::int32_t>(std::floor(least)) - 1,
          static_cast<std::int32_t>(std::ceil(greatest)) + 1};
}

/// The parts that make a step, up to the first that is 0; throws where a part's sign is not `sign`
/// or a part farther out says something again.
std::vector<std::uint8_t> steps_of(const std::vector<int>& centilogits,
                                   int sign,
                                   const OccupancyGrid& grid) {
  std::vector<std::uint8_t> steps;
  bool has_ended = false;
  for (const int part : centilogits) {
    const StepPair pair = grid.steps(sign * part);
    has_ended = has_ended || pair.up == 0;
    if (pair.down != 0 || (has_ended && pair.up != 0)) {
      throw std::invalid_argument(
          "cone insertion: free evidence is below 0, arc evidence above, and only the outermost "
          "parts are 0");
    }
    steps.push_back(pair.up);
  }
  return steps;
}

/// The cells' share of a sector: the outermost parts that say nothing are cut off.
ConeSector sector_of(const ConeInsertionParams& params,
                     const std::vector<int>& centilogits,
                     int sign,
                     const OccupancyGrid& grid) {
  std::vector<std::uint8_t> steps = steps_of(centilogits, sign, grid);
  const auto all = static_cast<double>(std::max<std::size_t>(1, steps.size()));
  steps.erase(std::find(steps.begin(), steps.end(), std::uint8_t{0}), steps.end());
  const double share = static_cast<double>(steps.size()) / all;
  return {steps,
          share * params.half_opening_rad,
          static_cast<std::int32_t>(std::ceil(params.reach_m / grid.resolution_m()))};
}

const ConeInsertionParams& checked(const ConeInsertionParams& params, const OccupancyGrid& grid) {
  constexpr double kMostCells = 2000.0;
  const bool opening_ok =
      params.half_opening_rad > 0.0 && params.half_opening_rad < std::numbers::pi / 2.0;
  const bool reach_ok = params.reach_m > 0.0 && params.reach_m <= kMostCells * grid.resolution_m();
  if (!opening_ok || !reach_ok || !(params.half_thickness_m >= 0.0)) {
    throw std::invalid_argument(
        "cone insertion: a half opening is within (0, pi / 2), a reach within (0, 2000 cells] and "
        "a thickness not negative");
  }
  return params;
}

}  // namespace

/// Where a cone stands, and the cells it has touched so far.
struct ConeInserter::Cone {
  CellIndex apex;
  std::size_t bearing = 0;
  CellBounds touched;
};

/// Cells by the square of their distance from the apex, in cells: more than `hole`, at most `rim`.
struct ConeInserter::Band {
  std::int32_t hole = -1;
  std::int32_t rim = -1;
};

ConeInserter::ConeInserter(const ConeInsertionParams& params, const OccupancyGrid& grid)
    : resolution_m_(grid.resolution_m()),
      half_thickness_m_(checked(params, grid).half_thickness_m),
      reach_cells_(params.reach_m / grid.resolution_m()),
      free_(sector_of(params, params.free_centilogits, -1, grid)),
      arc_(sector_of(params, params.arc_centilogits, 1, grid)) {}

void ConeInserter::insert(const ConeReading& reading, OccupancyGrid& grid) {
  const geometry::Pose2& T_map_sonar = reading.T_map_sonar;
  const double arc_m = reading.arc_range_m.value_or(0.0);
  if (!T_map_sonar.position_m().allFinite() || !std::isfinite(T_map_sonar.heading_rad()) ||
      !std::isfinite(reading.free_range_m) || !std::isfinite(arc_m)) {
    return;
  }
  const CellIndex cell = grid.cell_at(T_map_sonar.position_m());
  const Eigen::Vector2d offset_m = T_map_sonar.position_m() - grid.center_m(cell);
  const double ahead_m = geometry::unit_vector(T_map_sonar.heading_rad()).dot(offset_m);
  const auto degrees = std::lround(geometry::degrees(T_map_sonar.heading_rad()));
  Cone cone{cell, static_cast<std::size_t>(degrees < 0 ? degrees + 360 : degrees), {}};

  grid.begin_insertion();
  Band floor{-1, last_within(reading.free_range_m + ahead_m)};
  if (reading.arc_range_m) {
    const Band arc{last_before(arc_m - half_thickness_m_ + ahead_m),
                   last_within(arc_m + half_thickness_m_ + ahead_m)};
    floor.rim = std::min(floor.rim, arc.hole);
    add_band(arc_, arc, &add_arc, cone, grid);
  }
  add_band(free_, floor, &add_floor, cone, grid);
  grid.end_insertion(cone.touched);
}

std::int32_t ConeInserter::last_within(double range_m) const {
  const double cells = std::min(range_m / resolution_m_, reach_cells_);
  return cells < 0.0 ? -1 : static_cast<std::int32_t>(cells * cells);
}

std::int32_t ConeInserter::last_before(double range_m) const {
  const double cells = std::min(range_m / resolution_m_, reach_cells_);
  return cells < 0.0 ? -1 : static_cast<std::int32_t>(std::ceil(cells * cells)) - 1;
}

void ConeInserter::add_band(
    ConeSector& sector, const Band& band, Kernel* kernel, Cone& cone, OccupancyGrid& grid) {
  if (sector.empty() || band.rim <= band.hole) {
    return;
  }
  const FacingSector& facing = sector.facing(cone.bearing);
  const Extent columns = extent(facing.along_x, band.hole, band.rim);
  Extent rows = extent(facing.along_y, band.hole, band.rim);
  rows.first = std::max(rows.first, facing.first_row);
  rows.last =
      std::min(rows.last, facing.first_row + static_cast<std::int32_t>(facing.rows.size()) - 1);
  if (rows.last < rows.first) {
    return;
  }
  const auto count = static_cast<std::size_t>(rows.last - rows.first + 1);
  const auto skipped = static_cast<std::size_t>(rows.first - facing.first_row);
  const auto sector_rows = std::span(facing.rows).subspan(skipped, count);
  prefetch(sector_rows.data(), sector_rows.size_bytes());
  outer_.resize(count);
  inner_.resize(count);
  half_widths(band.rim, rows.first, outer_);
  half_widths(band.hole, rows.first, inner_);
  const std::uint32_t steps_begin = sector_rows.front().steps_begin;
  prefetch(&facing.steps[steps_begin], sector_rows.back().steps_begin - steps_begin);
  const RingRows ring{sector_rows, outer_, inner_, facing.steps.data()};
  const CellBounds cells{{cone.apex.x + columns.first, cone.apex.y + rows.first},
                         {cone.apex.x + columns.last, cone.apex.y + rows.last}};
  for (std::int32_t y = cells.min.y >> kTileBits; y <= cells.max.y >> kTileBits; ++y) {
    for (std::int32_t x = cells.min.x >> kTileBits; x <= cells.max.x >> kTileBits; ++x) {
      add_to_tile(ring, cells.min.y, {x, y}, kernel, cone, grid);
    }
  }
}

void ConeInserter::add_to_tile(const RingRows& ring,
                               std::int32_t bottom,
                               CellIndex tile,
                               Kernel* kernel,
                               Cone& cone,
                               OccupancyGrid& grid) {
  const CellIndex corner{tile.x << kTileBits, tile.y << kTileBits};
  const std::int32_t below = std::max(corner.y - bottom, 0);
  const RingPlace place{bottom + below - corner.y, cone.apex.x - corner.x};
  const RingRows part = ring.rows_from(static_cast<std::size_t>(below),
                                       static_cast<std::size_t>(kTileSide - place.first_row));
  if (!reaches(part, place)) {
    return;
  }
  const TouchedCells touched = kernel(part, place, grid.limits(), grid.writable_tile(tile));
  cone.touched = united(cone.touched,
                        {{corner.x + touched.first_column, corner.y + touched.first_row},
                         {corner.x + touched.last_column, corner.y + touched.last_row}});
}

}  // namespace echomap::mapping
