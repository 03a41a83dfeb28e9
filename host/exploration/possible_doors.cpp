// SPDX-License-Identifier: MIT
#include "host/exploration/possible_doors.hpp"

#include <algorithm>
#include <cmath>

#include "host/exploration/unobserved_walls.hpp"
#include "host/geometry/angle.hpp"

namespace echomap::exploration {

using geometry::Segment;
using mapping::RasterMap;

namespace {

/// A stop that faces the wall, near enough to tell.
bool can_tell(const RasterMap& map,
              const PastView& view,
              const Segment& wall,
              const PossibleDoorParams& params) {
  if (mapping::end_excess_m(view.from_m, wall) < params.told_apart_m) {
    return false;
  }
  UnobservedWallParams facing;
  facing.max_distance_m = params.max_distance_m;
  const auto bearing_rad = facing_rad(map, view.from_m, wall, facing);
  return bearing_rad && view.covers(*bearing_rad);
}

/// Whether the map has the floor behind it, so that there is nothing to find out.
bool is_passed(const RasterMap& map, const Segment& door) {
  constexpr double kBehindCells = 2.0;
  const Eigen::Vector2d behind_m = before_m({door}, -kBehindCells * map.resolution_m());
  return map.state(map.cell_at(behind_m)) == mapping::CellState::kFree;
}

/// The distance at which the ends of a wall, seen from before its middle, are `told_apart_m`
/// farther off than the wall.
double telling_distance_m(const Segment& wall, const PossibleDoorParams& params) {
  const double half_m = 0.5 * wall.length_m();
  return std::min(params.max_distance_m,
                  0.5 * (half_m * half_m / params.told_apart_m - params.told_apart_m));
}

std::size_t tries_of(const Segment& door,
                     const std::vector<Eigen::Vector2d>& tried_m,
                     const PossibleDoorParams& params) {
  const Eigen::Vector2d middle_m = before_m({door}, 0.0);
  return static_cast<std::size_t>(
      std::ranges::count_if(tried_m, [&](const Eigen::Vector2d& other_m) {
        return (other_m - middle_m).norm() < params.apart_m;
      }));
}

std::optional<DoorStand> stand_before(const RasterMap& map,
                                      const Segment& door,
                                      const TravelField& travel,
                                      std::size_t tries,
                                      const PossibleDoorParams& params) {
  for (std::size_t i = tries; i < params.stand_shares.size(); ++i) {
    const double distance_m = params.stand_shares[i] * telling_distance_m(door, params);
    const Eigen::Vector2d at_m = before_m({door}, distance_m);
    const auto cost_m = travel.cost_m(map.cell_at(at_m));
    if (cost_m && can_tell(map, {at_m, 0.0, geometry::kFullTurnRad}, door, params)) {
      return DoorStand{before_m({door}, 0.0), at_m, *cost_m};
    }
  }
  return std::nullopt;
}

}  // namespace

std::vector<Segment> possible_doors(const RasterMap& map,
                                    const std::vector<Segment>& unheard,
                                    const std::vector<PastView>& views,
                                    const PossibleDoorParams& params) {
  constexpr double kRoundingM = 1e-3;
  std::vector<Segment> doors;
  for (const Segment& wall : unheard) {
    if (wall.length_m() >= params.min_width_m - kRoundingM && !is_passed(map, wall) &&
        std::none_of(views.begin(), views.end(), [&](const PastView& view) {
          return can_tell(map, view, wall, params);
        })) {
      doors.push_back(wall);
    }
  }
  return doors;
}

std::optional<DoorStand> nearest_door_stand(const RasterMap& map,
                                            const std::vector<Segment>& doors,
                                            const TravelField& travel,
                                            const std::vector<Eigen::Vector2d>& tried_m,
                                            const PossibleDoorParams& params) {
  std::optional<DoorStand> nearest;
  for (const Segment& door : doors) {
    const auto stand = stand_before(map, door, travel, tries_of(door, tried_m, params), params);
    if (stand && (!nearest || stand->cost_m < nearest->cost_m)) {
      nearest = stand;
    }
  }
  return nearest;
}

}  // namespace echomap::exploration
