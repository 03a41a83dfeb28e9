// SPDX-License-Identifier: MIT
#include "host/mapping/cone_insertion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "host/geometry/unit_vector.hpp"

namespace echomap::mapping {

namespace {

using geometry::CellIndex;

/// The steps that the parts make; throws for too many of them, and where a part's sign is not
/// `sign` or one beyond a part of 0 says something again.
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
  if (steps.size() > kMostWedges) {
    throw std::invalid_argument("cone insertion: a half opening has at most 8 parts");
  }
  return steps;
}

/// The borders at which the steps change, from the outermost to the innermost.
struct Borders {
  std::vector<Eigen::Vector2d> half_openings;
  std::vector<std::uint8_t> heights;
};

Borders borders_of(const std::vector<std::uint8_t>& steps_by_angle, double half_opening_rad) {
  Borders borders;
  std::uint8_t outside = 0;
  for (std::size_t parts = steps_by_angle.size(); parts != 0; --parts) {
    const std::uint8_t inside = steps_by_angle[parts - 1];
    if (inside != outside) {
      const double share = static_cast<double>(parts) / static_cast<double>(steps_by_angle.size());
      borders.half_openings.push_back(geometry::unit_vector(share * half_opening_rad));
      borders.heights.push_back(static_cast<std::uint8_t>(inside - outside));
    }
    outside = inside;
  }
  return borders;
}

const ConeInsertionParams& checked(const ConeInsertionParams& params, const OccupancyGrid& grid) {
  const bool opening_ok =
      params.half_opening_rad > 0.0 && params.half_opening_rad < std::numbers::pi / 2.0;
  const bool reach_ok =
      params.reach_m > 0.0 && params.reach_m <= kMostSectorCells * grid.resolution_m();
  if (!opening_ok || !reach_ok || !(params.half_thickness_m >= 0.0)) {
    throw std::invalid_argument(
        "cone insertion: a half opening is within (0, pi / 2), a reach within (0, 2000 cells] and "
        "a thickness not negative");
  }
  return params;
}

}  // namespace

ConeInserter::ConeInserter(const ConeInsertionParams& params, const OccupancyGrid& grid)
    : resolution_m_(grid.resolution_m()),
      half_thickness_m_(checked(params, grid).half_thickness_m),
      reach_cells_(params.reach_m / grid.resolution_m()),
      free_(evidence(steps_of(params.free_centilogits, -1, grid), params.half_opening_rad)),
      arc_(evidence(steps_of(params.arc_centilogits, 1, grid), params.half_opening_rad)) {}

ConeInserter::Evidence ConeInserter::evidence(const std::vector<std::uint8_t>& steps_by_angle,
                                              double half_opening_rad) const {
  const Borders borders = borders_of(steps_by_angle, half_opening_rad);
  const auto reach = static_cast<std::int32_t>(std::ceil(reach_cells_));
  return {borders.half_openings,
          WedgeSteps(borders.heights, reach),
          SectorRows(borders.heights.size(), reach)};
}

void ConeInserter::insert(const ConeReading& reading, OccupancyGrid& grid) {
  const geometry::Pose2& T_map_sonar = reading.T_map_sonar;
  const double arc_m = reading.arc_range_m.value_or(0.0);
  if (!T_map_sonar.position_m().allFinite() || !std::isfinite(T_map_sonar.heading_rad()) ||
      !std::isfinite(reading.free_range_m) || !std::isfinite(arc_m)) {
    return;
  }
  const Cone cone{grid.cell_at(T_map_sonar.position_m()),
                  geometry::unit_vector(T_map_sonar.heading_rad())};
  const double ahead_m = cone.axis.dot(T_map_sonar.position_m() - grid.center_m(cone.apex));

  grid.begin_insertion();
  Ring floor{-1, last_within(reading.free_range_m + ahead_m)};
  if (reading.arc_range_m) {
    const Ring arc{last_before(arc_m - half_thickness_m_ + ahead_m),
                   last_within(arc_m + half_thickness_m_ + ahead_m)};
    floor.rim = std::min(floor.rim, arc.hole);
    add(arc_, arc, &add_arc, cone, grid);
  }
  add(free_, floor, &add_floor, cone, grid);
}

std::int32_t ConeInserter::last_within(double range_m) const {
  const double cells = std::min(range_m / resolution_m_, reach_cells_);
  return cells < 0.0 ? -1 : static_cast<std::int32_t>(cells * cells);
}

std::int32_t ConeInserter::last_before(double range_m) const {
  const double cells = std::min(range_m / resolution_m_, reach_cells_);
  return cells < 0.0 ? -1 : static_cast<std::int32_t>(std::ceil(cells * cells)) - 1;
}

void ConeInserter::add(
    Evidence& evidence, const Ring& ring, Kernel* kernel, const Cone& cone, OccupancyGrid& grid) {
  if (evidence.half_openings.empty() || ring.rim <= ring.hole) {
    return;
  }
  wedges_.clear();
  for (const Eigen::Vector2d& half_opening : evidence.half_openings) {
    wedges_.emplace_back(cone.axis, half_opening);
  }
  evidence.rows.lay_out(wedges_, ring);
  const CellBounds& bounds = evidence.rows.bounds();
  if (bounds.empty()) {
    return;
  }
  const CellBounds touched{{cone.apex.x + bounds.min.x, cone.apex.y + bounds.min.y},
                           {cone.apex.x + bounds.max.x, cone.apex.y + bounds.max.y}};
  for (std::int32_t strip = touched.min.x >> kPatchBits; strip <= touched.max.x >> kPatchBits;
       ++strip) {
    add_strip(evidence, strip << kPatchBits, kernel, cone.apex, grid);
  }
  grid.end_insertion(touched);
}

void ConeInserter::add_strip(const Evidence& evidence,
                             std::int32_t column,
                             Kernel* kernel,
                             CellIndex apex,
                             OccupancyGrid& grid) {
  constexpr std::int32_t kInTile = kTileSide - 1;
  const std::int32_t first_column = column - apex.x;
  const Stretch rows = evidence.rows.rows_in({first_column, first_column + kPatchSide - 1});
  for (std::int32_t row = rows.first; row <= rows.last;) {
    const std::int32_t y = apex.y + row;
    const std::int32_t last = std::min(rows.last, (y | kInTile) - apex.y);
    GridTile& tile = grid.writable_tile({column >> kTileBits, y >> kTileBits});
    kernel(evidence.rows,
           evidence.steps,
           {first_column, {row, last}},
           grid.limits(),
           tile.row(y & kInTile) + (column & kInTile));
    row = last + 1;
  }
}

}  // namespace echomap::mapping
