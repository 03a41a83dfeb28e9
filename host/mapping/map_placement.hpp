// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "host/geometry/pose2.hpp"
#include "host/mapping/placeable_map.hpp"

namespace echomap::mapping {

/// When two maps are of one place; ours, chosen in simulated rooms
/// (docs/algorithms/map_joining.md). Walls are counted in metres, of both maps together.
struct MapPlacementParams {
  /// Walls of two maps lie this far apart.
  double wall_stddev_m = 0.08;
  /// A wall that lies so deep in the other map's floor speaks against it.
  double floor_depth_m = 0.15;
  /// Placements that are nearer to each other are one.
  double apart_m = 0.5;
  double apart_rad = 0.35;
  /// A sure placement has so much wall in common,
  double min_common_m = 4.0;
  /// as such a share of the wall that lies where both maps know something, at least,
  double min_share = 0.6;
  /// and is ahead of any other one by so much, of which less than such a share speaks for that.
  double min_lead_m = 1.8;
  double max_rival_share = 0.6;
};

/// Where a map may lie on another one.
struct MapPlacement {
  geometry::Pose2 T_previous_later;
  double common_m = 0.0;         ///< Wall of either map that lies on wall of the other.
  double contradicting_m = 0.0;  ///< Wall of either map that lies on floor of the other.
  double known_m = 0.0;          ///< Wall of either map where the other one knows something.

  /// What a wall on floor counts, against one on a wall.
  static constexpr double kContradiction = 2.0;

  /// What speaks for it: as much wall, had nothing spoken against it.
  double weight_m() const { return common_m - kContradiction * contradicting_m; }
};

/// All ways to lay `later` onto `previous` that walls and floor speak for, wherever it may lie and
/// however turned, the best first: correlative matching (Olson 2009) on a coarse lattice, and finer
/// around the best of them. Both maps have one resolution.
std::vector<MapPlacement> find_placements(const PlaceableMap& previous,
                                          const PlaceableMap& later,
                                          const MapPlacementParams& params = {});

/// The first of them where there is enough that speaks for it, hardly anything against it and no
/// other one is as good: rooms are nearly symmetric, and a wrong placement is worse than none.
std::optional<MapPlacement> sure_placement(const std::vector<MapPlacement>& placements,
                                           const MapPlacementParams& params = {});

}  // namespace echomap::mapping
