// SPDX-License-Identifier: MIT
#include "host/exploration/unobserved_walls.hpp"

#include <algorithm>
#include <cmath>

namespace echomap::exploration {

namespace {

using mapping::CellState;
using mapping::RasterMap;

/// A wall is drawn in cells up to so many cells before its line.
constexpr double kDrawnCells = 2.0;

bool is_hidden(const RasterMap& map,
               const Eigen::Vector2d& from_m,
               const Eigen::Vector2d& direction,
               double distance_m) {
  const double step_m = map.resolution_m();
  const auto steps = static_cast<int>(std::ceil(distance_m / step_m - kDrawnCells));
  for (int i = 0; i < steps; ++i) {
    if (map.state(map.cell_at(from_m + i * step_m * direction)) == CellState::kOccupied) {
      return true;
    }
  }
  return false;
}

}  // namespace

Eigen::Vector2d before_m(const UnobservedWall& unobserved, double distance_m) {
  return 0.5 * (unobserved.wall.from_m + unobserved.wall.to_m) +
         distance_m * geometry::left_normal(unobserved.wall);
}

std::vector<UnobservedWall> unobserved_walls(const std::vector<geometry::Segment>& walls,
                                             double depth_m,
                                             const UnobservedWallParams& params) {
  std::vector<UnobservedWall> unobserved;
  for (const geometry::Segment& wall : walls) {
    const double length_m = wall.length_m();
    if (length_m >= params.min_length_m) {
      const double door_share =
          std::min(1.0, (length_m - params.min_length_m) / (params.door_m - params.min_length_m));
      unobserved.push_back({wall, door_share * params.floor_chance * length_m * depth_m});
    }
  }
  return unobserved;
}

std::optional<double> facing_rad(const RasterMap& map,
                                 const Eigen::Vector2d& from_m,
                                 const geometry::Segment& wall,
                                 const UnobservedWallParams& params) {
  const Eigen::Vector2d along = (wall.to_m - wall.from_m).normalized();
  const Eigen::Vector2d to_wall = -geometry::left_normal(wall);
  const double foot_m = along.dot(from_m - wall.from_m);
  const double distance_m = to_wall.dot(wall.from_m - from_m);
  const bool is_on_it = foot_m >= params.inside_m && foot_m <= wall.length_m() - params.inside_m;
  const bool is_before_it = distance_m > 0.0 && distance_m <= params.max_distance_m;
  if (!is_on_it || !is_before_it || is_hidden(map, from_m, to_wall, distance_m)) {
    return std::nullopt;
  }
  return std::atan2(to_wall.y(), to_wall.x());
}

}  // namespace echomap::exploration
