// SPDX-License-Identifier: MIT
#include "host/mapping/scan_check.hpp"

#include <algorithm>
#include <cmath>

#include "host/geometry/angle.hpp"
#include "host/mapping/echo_arc.hpp"

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

/// How the echoes of a scan agree with a map, and how many of them lie on firm floor.
struct Agreement {
  ScanFit fit;
  std::size_t on_firm_floor = 0;
};

Agreement agreement_of(const Scan& scan, const OccupancyGrid& map, const ScanCheckParams& params) {
  Agreement agreement;
  for (const PlacedReading& reading : scan) {
    if (reading.range_m) {
      const EchoArc arc = arc_of(reading, map, params);
      agreement.fit.on_walls += arc.occupied > 0 ? 1 : 0;
      agreement.fit.on_floor += arc.is_floor() ? 1 : 0;
      agreement.on_firm_floor += arc.is_firm_floor(params.max_other_share) ? 1 : 0;
    }
  }
  return agreement;
}

/// Whether of enough known echoes more than this share lie on floor.
bool is_elsewhere(std::size_t on_walls,
                  std::size_t on_floor,
                  double max_share,
                  const ScanCheckParams& params) {
  const std::size_t known = on_walls + on_floor;
  return known >= params.min_echoes &&
         static_cast<double>(on_floor) > max_share * static_cast<double>(known);
}

}  // namespace

std::shared_ptr<const OccupancyGrid> compared_map(std::shared_ptr<const OccupancyGrid> map,
                                                  const std::vector<Scan>& scans) {
  constexpr std::size_t kYoungScans = 3;
  constexpr int kSurelyOccupied = 1000;
  if (scans.size() >= kYoungScans) {
    return map;
  }
  auto heard = std::make_shared<OccupancyGrid>(*map);
  for (const Scan& scan : scans) {
    for (const PlacedReading& reading : scan) {
      if (const auto echo_m = echo_point_m(reading)) {
        heard->add(heard->cell_at(*echo_m), kSurelyOccupied);
      }
    }
  }
  return heard;
}

ScanFit fit_of(const Scan& scan, const OccupancyGrid& map, const ScanCheckParams& params) {
  return agreement_of(scan, map, params).fit;
}

OccupancyGrid grid_of(const RasterMap& map) {
  OccupancyGridParams params;
  params.resolution_m = map.resolution_m();
  OccupancyGrid grid(params);
  for (int y = 0; y < map.rows(); ++y) {
    for (int x = 0; x < map.columns(); ++x) {
      if (const CellState state = map.state({x, y}); state != CellState::kUnknown) {
        grid.add({x, y},
                 state == CellState::kFree ? -params.clamp_centilogits : params.clamp_centilogits);
      }
    }
  }
  return grid;
}

ScanFault fault_of(const Scan& scan, const OccupancyGrid& map, const ScanCheckParams& params) {
  if (scan.size() < params.min_readings) {
    return ScanFault::kNone;
  }
  if (is_stuck(scan, params)) {
    return ScanFault::kStuck;
  }
  const auto [fit, on_firm_floor] = agreement_of(scan, map, params);
  const bool is_of_here =
      !is_elsewhere(fit.on_walls, fit.on_floor, 1.0 - params.min_share, params) &&
      !is_elsewhere(fit.on_walls, on_firm_floor, params.max_firm_share, params);
  return is_of_here ? ScanFault::kNone : ScanFault::kElsewhere;
}

}  // namespace echomap::mapping
