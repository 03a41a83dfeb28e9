// SPDX-License-Identifier: MIT
#include "host/team_map/map_proposals.hpp"

#include <algorithm>

namespace echomap::team_map {

namespace {

using geometry::Pose2;
using mapping::MapPlacement;
using mapping::MapPlacementParams;
using mapping::PlaceableMap;

/// Adds what the walls of one map say of their place in the other.
void weigh_walls(const PlaceableMap& of,
                 const PlaceableMap& on,
                 const Pose2& T_on_of,
                 const MapPlacementParams& params,
                 MapPlacement& placement) {
  const double cell_m = of.map().resolution_m();
  for (const Eigen::Vector2d& wall_m : of.walls_m()) {
    const Eigen::Vector2d point_m = T_on_of * wall_m;
    const double common = on.wall_at(point_m, params.wall_stddev_m);
    const bool contradicts = on.is_deep_in_floor(point_m, params.floor_depth_m);
    placement.common_m += cell_m * common;
    placement.contradicting_m += contradicts ? cell_m : 0.0;
    placement.known_m += cell_m * (contradicts || on.knows(point_m) ? 1.0 : common);
  }
}

void add_best(const std::vector<MapPlacement>& found,
              std::size_t count,
              std::vector<MapPlacement>& proposed) {
  const auto end = found.begin() + static_cast<std::ptrdiff_t>(std::min(count, found.size()));
  proposed.insert(proposed.end(), found.begin(), end);
}

}  // namespace

std::vector<MapPlacement> propose_placements(const RobotMap& first,
                                             const RobotMap& second,
                                             const MapPlacementParams& params,
                                             std::size_t count) {
  std::vector<MapPlacement> proposed;
  add_best(mapping::find_placements(first.map(), second.map(), params), count, proposed);
  std::vector<MapPlacement> by_windows;
  if (second.has_window()) {
    add_best(mapping::find_placements(first.map(), second.window(), params), count, by_windows);
  }
  if (first.has_window()) {
    const std::size_t before = by_windows.size();
    add_best(mapping::find_placements(second.map(), first.window(), params), count, by_windows);
    for (std::size_t i = before; i < by_windows.size(); ++i) {
      by_windows[i].T_previous_later = by_windows[i].T_previous_later.inverse();
    }
  }
  for (const MapPlacement& one : by_windows) {
    MapPlacement whole{one.T_previous_later};
    weigh_walls(second.map(), first.map(), whole.T_previous_later, params, whole);
    weigh_walls(first.map(), second.map(), whole.T_previous_later.inverse(), params, whole);
    proposed.push_back(whole);
  }
  return proposed;
}

}  // namespace echomap::team_map
