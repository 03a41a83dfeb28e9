// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "host/evaluation/map_alignment.hpp"
#include "host/mapping/raster_map.hpp"

namespace echomap::evaluation {

/// Something stands where there was floor, or the other way round.
enum class ChangeKind : std::uint8_t { kAppeared, kVanished };

/// A place that changed between two maps, in the frame of the first.
struct ChangedRegion {
  ChangeKind kind = ChangeKind::kAppeared;
  /// Middle and size of the smallest upright rectangle around its cells.
  Eigen::Vector2d center_m = Eigen::Vector2d::Zero();
  Eigen::Vector2d size_m = Eigen::Vector2d::Zero();
  /// Centres of the cells that are floor in one map and taken in the other, and their area.
  std::vector<Eigen::Vector2d> cells_m;
  double area_m2 = 0.0;
  /// 0 to 1, growing with the area (docs/guides/maps.md).
  double confidence = 0.0;
};

/// What changed between two maps of a room.
struct MapDifference {
  MapAlignment alignment;
  /// The surest first.
  std::vector<ChangedRegion> regions;
};

/// When maps contradict each other.
struct MapDifferenceParams {
  MapAlignmentParams alignment;
  /// Floor this near to its border is not trusted: what two runs call floor ends so differently
  /// (this and what follows: fitted in simulated rooms, docs/guides/maps.md).
  double border_m = 0.3;
  /// A wall of one map that is nearer than this to a wall of the other is the same wall.
  double same_wall_m = 0.25;
  /// What is floor in one map has a wall of the other where the centre of one is nearer than this.
  double wall_reach_m = 0.15;
  /// Farther from a wall that stands on floor, lost floor may as well be its shadow.
  double reach_m = 0.3;
  /// A region of this area is a change with a confidence of 1 - 1 / e.
  double area_scale_m2 = 0.03;
  /// A region with less confidence is not told.
  double min_confidence = 0.65;
};

/// Lays `after` onto `before` and finds where well inside the floor of one map the other has no
/// floor but a wall. What only one of the maps has seen is no change. Empty where the maps have
/// nothing in common. Throws std::invalid_argument for parameters that are not above zero.
std::optional<MapDifference> find_difference(const mapping::RasterMap& before,
                                             const mapping::RasterMap& after,
                                             const MapDifferenceParams& params = {});

}  // namespace echomap::evaluation
