// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <deque>
#include <vector>

#include <Eigen/Core>

#include "host/mapping/floor_evidence.hpp"
#include "host/mapping/lone_surfaces.hpp"
#include "host/mapping/occupancy_grid.hpp"
#include "host/mapping/placed_reading.hpp"
#include "host/mapping/sonar_features.hpp"
#include "host/mapping/sonar_surfaces.hpp"
#include "host/mapping/stop_floor.hpp"
#include "host/mapping/surface_matching.hpp"

namespace echomap::mapping {

/// Evidence is in hundredths of log-odds; the weights are ours, chosen in simulated rooms.
struct SonarMapperParams {
  OccupancyGridParams grid;
  SonarSurfaceParams surfaces;
  SurfaceMatchingParams matching{.contradiction_weight = 0.3};
  SonarFeaturesParams features;
  StopFloorParams floor;
  FloorEvidenceParams evidence;
  LoneSurfaceParams lone;
  /// Evidence for a wall or round thing that several stops agree on.
  int matched_centilogits = 500;
  /// Such a wall is drawn so far behind its face: floor ends in the middle of a cell, and the half
  /// before the wall is floor.
  double drawn_behind_m = 0.015;
  /// A stop that is moved, or a feature that moves, by less than this stays where it is drawn.
  double still_m = 0.003;
  double still_rad = 0.002;
};

/// Makes an occupancy grid of sonar scans. Not reading by reading: the readings of a stop are
/// resolved into surfaces, the surfaces of all stops are matched to walls and round things, and
/// only then is evidence put into cells (docs/algorithms/sonar_grid.md). A new stop is matched with
/// those about it, and changes only the cells that it says something else of.
class SonarMapper {
 public:
  /// Throws std::invalid_argument for invalid parameters.
  explicit SonarMapper(const SonarMapperParams& params = {});

  /// Takes the readings of all stops so far, as they are placed now, for those of before, and where
  /// the robot's centre has been so far. In the map frame.
  void take(const std::vector<Scan>& scans, const std::vector<Eigen::Vector2d>& track_m);

  /// The grid of all scans so far; without any echo, an untouched one.
  OccupancyGrid grid() const;
  /// What that grid is drawn from.
  const SonarFeatures& features() const { return features_; }

 private:
  /// Answers which scans are new or have moved.
  std::vector<std::size_t> place(const std::vector<Scan>& scans);
  void update_floor(const SonarFeatures& before, const std::vector<std::size_t>& moved);
  void update_lone();

  SonarMapperParams params_;
  /// Of each scan: its readings and its surfaces, as it was placed when it moved last, and what it
  /// says of the floor.
  std::vector<Scan> readings_;
  std::vector<ScanSurfaces> surfaces_;
  std::deque<StopFloor> floors_;  ///< Large: growing must not move them.
  SurfaceMatcher matcher_;
  MatchedSurfaces matched_;
  SonarFeatures features_;
  FloorEvidence evidence_;
  LoneSurfaces lone_;
};

}  // namespace echomap::mapping
