// SPDX-License-Identifier: MIT
#pragma once

#include <bitset>
#include <cstddef>
#include <numbers>
#include <vector>

#include <Eigen/Core>

#include "host/geometry/segment.hpp"
#include "host/geometry/unit_vector.hpp"
#include "host/mapping/surface_matching.hpp"
#include "host/mapping/wall_completion.hpp"

namespace echomap::mapping {

/// A compact obstacle as a sonar measures it: its face lies on a circle. A post or a corner is one
/// of radius 0.
struct FittedCircle {
  /// Its rim is known in sectors of the full turn, from bearing -pi on, seen from the centre.
  static constexpr std::size_t kSectors = 36;
  static constexpr double kSectorRad = 2.0 * std::numbers::pi / kSectors;

  Eigen::Vector2d center_m = Eigen::Vector2d::Zero();
  double radius_m = 0.0;
  /// Sectors that some stop has looked at.
  std::bitset<kSectors> seen;

  /// The point of the rim where sector `index` begins.
  Eigen::Vector2d rim_m(std::size_t index) const {
    const double bearing_rad = -std::numbers::pi + static_cast<double>(index) * kSectorRad;
    return center_m + radius_m * geometry::unit_vector(bearing_rad);
  }
};

/// The things that several stops have measured, in the map frame: what a sonar map is drawn from.
struct SonarFeatures {
  /// Straight pieces of wall, prolonged to their corners. The floor is to the left of each.
  std::vector<geometry::Segment> walls;
  std::vector<FittedCircle> circles;
  /// Stretches of the walls that nobody has heard: gaps that were closed. The floor is to the left.
  std::vector<geometry::Segment> unobserved = {};
  /// Those, what no stop has had an answer from at right angles, where a door's frame may be what
  /// has answered (door_evidence), and gaps that are open.
  std::vector<geometry::Segment> unheard = {};
};

/// What is taken for solid. Ours, chosen in simulated rooms.
struct SonarFeaturesParams {
  WallCompletionParams completion;
  /// Nothing stands nearer to where the robot's centre has been than this.
  double track_clearance_m = 0.07;
  /// A sighting runs through a wall if it ends farther behind it than this.
  double image_clearance_m = 0.12;
  /// A circle is seen so far to both sides of the direction of a stop.
  double seen_rim_rad = 0.61;
};

/// Tells what stands in a room from what its stops have measured together and where the robot's
/// centre has been. Leaves out images: what is seen through walls, mirrored by them.
SonarFeatures sonar_features(const MatchedSurfaces& matched,
                             const std::vector<ScanSurfaces>& scans,
                             const std::vector<Eigen::Vector2d>& track_m,
                             const SonarFeaturesParams& params);

}  // namespace echomap::mapping
