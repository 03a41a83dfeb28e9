// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "host/mapping/occupancy_grid.hpp"
#include "host/mapping/placed_reading.hpp"
#include "host/mapping/sonar_view.hpp"
#include "host/mapping/sonar_walls.hpp"
#include "host/models/sonar_cone.hpp"

namespace echomap::mapping {

/// One setting for the sensor kind; evidence in natural log-odds.
struct SonarConeMapperParams {
  OccupancyGridParams grid;
  models::SonarConeParams cone;
  /// Whether smooth walls throw what meets them at a slant aside, as they do sound. Light they
  /// scatter: it comes back from everywhere, and no walls are sought.
  bool is_sound = true;
  SonarWallParams walls;
  /// A sonar that has moved less is in the same place.
  double same_place_m = 0.03;
  /// Evidence for the cells of a piece of wall, for every pair of views that found it, and at most.
  double wall_evidence = 0.5;
  double max_wall_evidence = 2.3;
  /// Chance that sound does not get through a found wall.
  double wall_opacity = 0.95;
  /// Chance that a found wall is one: what the views that see through it say counts by the rest.
  double wall_weight = 0.8;
  /// Floor that has been under the robot is free: hardly a wheeled robot is narrower than this
  /// disc.
  double robot_radius_m = 0.1;
  /// Chance that something stands there nevertheless: the pose was wrong.
  double under_robot_chance = 0.05;
  /// How often the arcs are shared out, each time by what has been learnt.
  int rounds = 2;
  /// An echo is a ghost if the chance that anything is there falls below this all along its arc.
  double ghost_chance = 0.03;
};

/// What became of the readings.
struct SonarReadingCounts {
  std::size_t readings = 0;
  /// Nothing answered: weak evidence for free floor.
  std::size_t silent = 0;
  /// The echo's whole arc lies behind a wall: a second bounce, or the wall threw the sound aside.
  std::size_t behind_wall = 0;
  /// Other views see through the echo's whole arc: a ghost, or something that has moved.
  std::size_t seen_through = 0;

  std::size_t used_echoes() const { return readings - silent - behind_wall - seen_through; }
  bool operator==(const SonarReadingCounts&) const = default;
};

/// A grid made of sonar readings, and how.
struct SonarConeMap {
  OccupancyGrid grid;
  SonarReadingCounts counts;
  std::size_t wall_pieces = 0;
};

/// Makes an occupancy grid of sonar readings along a drive whose poses are given
/// (docs/algorithms/sonar_cone.md). All readings are kept and understood together whenever a map is
/// asked for. SonarMapper is for stops with dense sweeps, whose poses it corrects as well.
class SonarConeMapper {
 public:
  /// Throws std::invalid_argument for invalid parameters.
  explicit SonarConeMapper(const SonarConeMapperParams& params = {});

  /// Adds readings in the order in which they were taken: of a sweep, of a ring, or one.
  void add(const Scan& scan);

  /// The map of all readings so far; without any, an untouched one. Throws std::length_error where
  /// the poses lie so far apart that no memory would do.
  SonarConeMap map() const;

 private:
  SonarConeMapperParams params_;
  models::SonarCone cone_;
  Scan readings_;
};

}  // namespace echomap::mapping
