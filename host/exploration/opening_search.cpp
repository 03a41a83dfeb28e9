// SPDX-License-Identifier: MIT
#include "host/exploration/opening_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "host/geometry/unit_vector.hpp"
#include "host/mapping/distance_field.hpp"

namespace echomap::exploration {

namespace {

using geometry::CellIndex;
using mapping::CellState;
using mapping::DistanceField;
using mapping::RasterMap;

/// An echo so far beyond a place does not come from there.
constexpr double kEchoMarginM = 0.1;

/// Where free floor ends, and the way from there on into the unknown.
struct Edge {
  Eigen::Vector2d at_m = Eigen::Vector2d::Zero();
  Eigen::Vector2d outward = Eigen::Vector2d::UnitX();
};

/// How far each cell is from free floor.
DistanceField distance_to_floor(const RasterMap& map, double max_m) {
  RasterMap floor = map;
  for (int y = 0; y < map.rows(); ++y) {
    const CellState* states = map.row(y);
    for (int x = 0; x < map.columns(); ++x) {
      floor.set({x, y}, states[x] == CellState::kFree ? CellState::kOccupied : CellState::kUnknown);
    }
  }
  return DistanceField(floor, max_m);
}

/// The edge of the floor nearest to a cell that is at most so many cells off it.
Edge nearest_edge(const RasterMap& map, CellIndex cell, std::int32_t reach) {
  Edge nearest;
  double nearest_m = std::numeric_limits<double>::infinity();
  const Eigen::Vector2d from_m = map.center_m(cell);
  for (std::int32_t y = cell.y - reach; y <= cell.y + reach; ++y) {
    for (std::int32_t x = cell.x - reach; x <= cell.x + reach; ++x) {
      const Eigen::Vector2d offset_m = from_m - map.center_m({x, y});
      if (map.state({x, y}) == CellState::kFree && offset_m.norm() < nearest_m) {
        nearest_m = offset_m.norm();
        nearest = {map.center_m({x, y}), offset_m.normalized()};
      }
    }
  }
  return nearest;
}

bool floor_lies_between(const RasterMap& map,
                        const Eigen::Vector2d& from_m,
                        const Eigen::Vector2d& to_m) {
  const auto steps = static_cast<int>((to_m - from_m).norm() / map.resolution_m()) + 1;
  for (int i = 0; i < steps; ++i) {
    const Eigen::Vector2d at_m = from_m + static_cast<double>(i) / steps * (to_m - from_m);
    if (map.state(map.cell_at(at_m)) != CellState::kFree) {
      return false;
    }
  }
  return true;
}

/// One reading of a stop, from where and which way.
struct Look {
  Eigen::Vector2d from_m = Eigen::Vector2d::Zero();
  Eigen::Vector2d axis = Eigen::Vector2d::UnitX();
  double range_m = std::numeric_limits<double>::infinity();  ///< Without answer it is endless.
};

/// What was heard at one stop, and the circle that all its looks lie in.
struct Stop {
  Eigen::Vector2d at_m = Eigen::Vector2d::Zero();
  double radius_m = 0.0;
  std::vector<Look> looks;
};

std::vector<Stop> stops_of(const std::vector<mapping::Scan>& scans) {
  std::vector<Stop> stops;
  for (const mapping::Scan& scan : scans) {
    if (scan.empty()) {
      continue;
    }
    Stop stop{scan.front().T_map_sonar.position_m(), 0.0, {}};
    for (const mapping::PlacedReading& reading : scan) {
      const Eigen::Vector2d from_m = reading.T_map_sonar.position_m();
      stop.radius_m = std::max(stop.radius_m, (from_m - stop.at_m).norm());
      stop.looks.push_back({from_m,
                            geometry::unit_vector(reading.T_map_sonar.heading_rad()),
                            reading.range_m.value_or(std::numeric_limits<double>::infinity())});
    }
    stops.push_back(std::move(stop));
  }
  return stops;
}

/// A beam of the stop went through the edge squarely to the place beyond, and none that way was
/// answered from about there.
bool listened_through(const Stop& stop,
                      const RasterMap& map,
                      const Edge& edge,
                      const Eigen::Vector2d& beyond_m,
                      const OpeningParams& params) {
  const double far_m = params.far_m + params.step_m;
  if ((beyond_m - stop.at_m).norm() > far_m + stop.radius_m) {
    return false;
  }
  const double cos_look = std::cos(params.look_half_angle_rad);
  const double cos_square = std::cos(params.square_rad);
  bool met_squarely = false;
  for (const Look& look : stop.looks) {
    const Eigen::Vector2d offset_m = beyond_m - look.from_m;
    const double distance_m = offset_m.norm();
    if (distance_m > far_m || offset_m.dot(look.axis) < cos_look * distance_m) {
      continue;
    }
    if (look.range_m <= distance_m + kEchoMarginM) {
      return false;
    }
    met_squarely |= offset_m.dot(edge.outward) >= cos_square * distance_m;
  }
  return met_squarely && floor_lies_between(map, stop.at_m, edge.at_m);
}

}  // namespace

std::vector<Opening> find_openings(const RasterMap& map,
                                   const std::vector<mapping::Scan>& scans,
                                   const OpeningParams& params) {
  const double step_cells = params.step_m / map.resolution_m();
  const double half_width_cells = params.half_width_m / map.resolution_m();
  const DistanceField to_floor = distance_to_floor(map, params.step_m + 2.0 * map.resolution_m());
  const DistanceField to_occupied(map, params.half_width_m + map.resolution_m());
  const auto is_narrow = [&](CellIndex cell) {
    return static_cast<double>(to_occupied.distance_cells(cell)) < half_width_cells;
  };
  const std::vector<Stop> stops = stops_of(scans);
  std::vector<Opening> openings;
  for (int y = 0; y < map.rows(); ++y) {
    for (int x = 0; x < map.columns(); ++x) {
      const auto off_cells = static_cast<double>(to_floor.distance_cells({x, y}));
      const bool is_step_away = off_cells >= step_cells && off_cells <= step_cells + 1.0;
      if (!is_step_away || map.state({x, y}) != CellState::kUnknown || is_narrow({x, y})) {
        continue;
      }
      const Edge edge = nearest_edge(map, {x, y}, 1 + static_cast<std::int32_t>(step_cells));
      if (!is_narrow(map.cell_at(edge.at_m)) &&
          std::any_of(stops.begin(), stops.end(), [&](const Stop& stop) {
            return listened_through(stop, map, edge, map.center_m({x, y}), params);
          })) {
        openings.push_back({edge.at_m, map.center_m({x, y})});
      }
    }
  }
  return openings;
}

}  // namespace echomap::exploration
