// SPDX-License-Identifier: MIT
#include "host/mapping/scan_check.hpp"

#include <algorithm>
#include <cmath>

#include "host/geometry/angle.hpp"
#include "host/geometry/unit_vector.hpp"

namespace echomap::mapping {
namespace {

/// Whether a row of readings, from `first` on, has one range over a wide angle.
bool hangs_from(const Scan& scan, std::size_t first, const ScanCheckParams& params) {
  double max_rad = 0.0;
  for (std::size_t i = first; i < scan.size(); ++i) {
    if (!scan[i].range_m ||
        // NOLINTNEXTLINE(bugprone-unchecked-optional-access): the first of a row has one
        std::abs(*scan[i].range_m - *scan[first].range_m) > params.same_range_m) {
      return false;
    }
    max_rad = std::max(max_rad,
                       std::abs(geometry::angle_between(scan[first].T_map_sonar.heading_rad(),
                                                        scan[i].T_map_sonar.heading_rad())));
    if (i - first + 1 >= params.same_readings && max_rad >= params.same_bearing_rad) {
      return true;
    }
  }
  return false;
}

bool is_stuck(const Scan& scan, const ScanCheckParams& params) {
  for (std::size_t first = 0; first + params.same_readings <= scan.size(); ++first) {
    if (scan[first].range_m && hangs_from(scan, first, params)) {
      return true;
    }
  }
  return false;
}

/// What stands on the arc of an echo: something wherever anything does.
CellState state_on_arc(const PlacedReading& reading,
                       const OccupancyGrid& map,
                       const ScanCheckParams& params) {
  const double step_m = 0.5 * map.resolution_m();
  // NOLINTNEXTLINE(bugprone-unchecked-optional-access): only echoes are asked about
  const double near_m = *reading.range_m - params.tolerance_m;
  // NOLINTNEXTLINE(bugprone-unchecked-optional-access): only echoes are asked about
  const double far_m = *reading.range_m + params.tolerance_m;
  std::size_t places = 0;
  std::size_t others = 0;
  // NOLINTNEXTLINE(clang-analyzer-security.FloatLoopCounter): no step counts, cells are wider
  for (double range_m = std::max(near_m, 0.0); range_m <= far_m; range_m += step_m) {
    const double turn_rad = step_m / std::max(range_m, step_m);
    // NOLINTNEXTLINE(clang-analyzer-security.FloatLoopCounter): no step counts, cells are wider
    for (double off_rad = -params.beam_half_angle_rad; off_rad <= params.beam_half_angle_rad;
         off_rad += turn_rad) {
      const geometry::CellIndex cell =
          map.cell_at(reading.T_map_sonar * (range_m * geometry::unit_vector(off_rad)));
      if (map.state(cell) == CellState::kOccupied) {
        return CellState::kOccupied;
      }
      ++places;
      others += map.centilogits(cell).value_or(0) > params.firm_floor_centilogits ? 1 : 0;
    }
  }
  const bool is_floor =
      static_cast<double>(others) <= params.max_other_share * static_cast<double>(places);
  return is_floor ? CellState::kFree : CellState::kUnknown;
}

}  // namespace

ScanFit fit_of(const Scan& scan, const OccupancyGrid& map, const ScanCheckParams& params) {
  ScanFit fit;
  for (const PlacedReading& reading : scan) {
    if (reading.range_m) {
      const CellState state = state_on_arc(reading, map, params);
      fit.on_walls += state == CellState::kOccupied ? 1 : 0;
      fit.on_floor += state == CellState::kFree ? 1 : 0;
    }
  }
  return fit;
}

ScanFault fault_of(const Scan& scan, const OccupancyGrid& map, const ScanCheckParams& params) {
  if (scan.size() < params.min_readings) {
    return ScanFault::kNone;
  }
  if (is_stuck(scan, params)) {
    return ScanFault::kStuck;
  }
  const ScanFit fit = fit_of(scan, map, params);
  const auto known = static_cast<double>(fit.on_walls + fit.on_floor);
  const bool is_of_here = static_cast<double>(fit.on_walls) >= params.min_share * known;
  return known < static_cast<double>(params.min_echoes) || is_of_here ? ScanFault::kNone
                                                                      : ScanFault::kElsewhere;
}

}  // namespace echomap::mapping
