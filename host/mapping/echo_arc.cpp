// SPDX-License-Identifier: MIT
#include "host/mapping/echo_arc.hpp"

#include <algorithm>

#include "host/geometry/unit_vector.hpp"

namespace echomap::mapping {

EchoArc arc_of(const PlacedReading& reading,
               const OccupancyGrid& map,
               const ScanCheckParams& params) {
  const double step_m = 0.5 * map.resolution_m();
  // NOLINTNEXTLINE(bugprone-unchecked-optional-access): only echoes are asked about
  const double near_m = *reading.range_m - params.tolerance_m;
  // NOLINTNEXTLINE(bugprone-unchecked-optional-access): only echoes are asked about
  const double far_m = *reading.range_m + params.tolerance_m;
  EchoArc arc;
  // NOLINTNEXTLINE(clang-analyzer-security.FloatLoopCounter): no step counts, cells are wider
  for (double range_m = std::max(near_m, 0.0); range_m <= far_m; range_m += step_m) {
    const double turn_rad = step_m / std::max(range_m, step_m);
    // NOLINTNEXTLINE(clang-analyzer-security.FloatLoopCounter): no step counts, cells are wider
    for (double off_rad = -params.beam_half_angle_rad; off_rad <= params.beam_half_angle_rad;
         off_rad += turn_rad) {
      const geometry::CellIndex cell =
          map.cell_at(reading.T_map_sonar * (range_m * geometry::unit_vector(off_rad)));
      const CellState state = map.state(cell);
      ++arc.places;
      arc.occupied += state == CellState::kOccupied ? 1 : 0;
      arc.unknown += state == CellState::kUnknown ? 1 : 0;
      arc.firm_floor += map.centilogits(cell).value_or(0) <= params.firm_floor_centilogits ? 1 : 0;
    }
  }
  return arc;
}

}  // namespace echomap::mapping
