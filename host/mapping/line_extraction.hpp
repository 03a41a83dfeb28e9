// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <Eigen/Core>

#include "host/mapping/line_fit.hpp"
#include "host/mapping/polygon_map.hpp"

namespace echomap::mapping {

/// When points are taken for a wall.
struct LineExtractionParams {
  /// A run of points with one farther than this from its chord is split, and neighbouring pieces
  /// with none farther than this from their common line are joined: 3 sigma of the sensor.
  double split_distance_m = 0.09;
  /// Between neighbours farther apart than this there is no wall.
  double max_gap_m = 0.3;
  /// Of each coordinate of a point; Singh and Bedi 2013, section 2.4, for the NXT's sonar.
  double point_stddev_m = 0.03;
  /// What is smaller is no wall but clutter.
  std::size_t min_points = 5;
  double min_length_m = 0.2;
};

/// Straight walls in points that are ordered as a robot sees them turning left: split and merge
/// (Pavlidis and Horowitz 1974), each line then fitted to its points. The lines keep the order.
/// Throws std::invalid_argument for invalid parameters.
std::vector<FittedLine> extract_lines(const std::vector<Eigen::Vector2d>& points_m,
                                      const LineExtractionParams& params = {});

/// Where two neighbouring walls meet.
struct WallCorner {
  Eigen::Vector2d position_m = Eigen::Vector2d::Zero();
  CornerKind kind = CornerKind::kNonReflex;
  /// Index of the wall before it; the next one comes after.
  std::size_t line = 0;
};

/// When two neighbouring lines are taken to meet.
struct WallCornerParams {
  /// Neither wall may end farther from the corner than this.
  double reach_m = 0.3;
  /// Walls with less of a turn between them, either way, are one wall badly seen.
  double min_turn_rad = 0.35;
};

/// Corners between neighbours of `lines`, which are in the order of extract_lines; with `closed`
/// also between the last and the first.
std::vector<WallCorner> find_corners(const std::vector<FittedLine>& lines,
                                     bool closed,
                                     const WallCornerParams& params = {});

}  // namespace echomap::mapping
