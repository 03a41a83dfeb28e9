// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "host/mapping/echo_feature.hpp"
#include "host/mapping/sonar_surfaces.hpp"

namespace echomap::mapping {

/// When sightings from several stops are taken for one wall, post or round thing.
struct SurfaceMatchingParams {
  /// A sighting belongs to a feature when its range is off by at most this: 2 sigma of the mean of
  /// a few readings plus the odometry's drift from stop to stop.
  double range_tolerance_m = 0.05;
  /// ... and its bearing by at most these. The range of a sighting is good to a centimetre or two,
  /// its bearing only to several degrees, where a region is cut short on one side.
  double wall_bearing_tolerance_rad = 0.35;
  double post_bearing_tolerance_rad = 0.26;
  /// It was heard at the foot of the perpendicular of a wall where it is longer by at most this.
  double foot_tolerance_m = 0.025;
  /// Standard deviations for the fit.
  double range_stddev_m = 0.025;
  double bearing_stddev_rad = 0.14;
  /// A sighting with this many readings, or more, counts fully.
  double full_readings = 10.0;
  /// A wall seen as a post, or the other way round, counts this much.
  double other_kind_weight = 0.6;
  /// Less support than this makes no feature: one full sighting and another, middling one.
  double min_support = 1.4;
  /// A piece of wall shorter than this between two seen pieces is there too: less than a door.
  double bridged_gap_m = 0.4;
  /// Round things are proposed with these radii, and fitted up to `max_radius_m`.
  std::vector<double> radii_m{0.05, 0.1, 0.15, 0.21, 0.28, 0.36};
  double max_radius_m = 0.42;
  /// Echoes farther apart are of no round thing.
  double max_echoes_apart_m = 0.9;
  /// A round thing takes this much support more than a wall or a post, and up to so much more the
  /// narrower the angle from which it was seen, below `one_sided_rad`: seen from one side it may as
  /// well be flat.
  double round_penalty = 0.1;
  double one_sided_penalty = 1.5;
  double one_sided_rad = 3.0;
  /// Support that a feature loses for each stop that contradicts it. 0 where stops are not where
  /// they belong yet, so that what they do not hear says nothing.
  double contradiction_weight = 0.0;
  /// Such a stop has heard nothing this near to the feature's direction before `contradiction_m`
  /// behind its face: more than noise and a slanted face. Beyond `contradiction_range_m` silence is
  /// usual.
  double contradiction_half_angle_rad = 0.11;
  double contradiction_m = 0.15;
  double contradiction_range_m = 3.0;
  /// A feature of so many sightings stays when new stops come; one of fewer is found again with
  /// theirs. `rematched_stops` is how many stops about a new one are matched anew with it.
  std::size_t settled_sightings = 16;
  std::size_t rematched_stops = 24;
};

/// Throws std::invalid_argument for invalid parameters.
void validate(const SurfaceMatchingParams& params);

/// A surface with the place it was seen from, in the map frame.
struct Sighting {
  std::size_t scan = 0;
  std::size_t index = 0;  ///< In its scan.
  Eigen::Vector2d center_m = Eigen::Vector2d::Zero();
  SonarSurface surface;
  Eigen::Vector2d echo_m = Eigen::Vector2d::Zero();

  RangeCircle circle() const { return {center_m, surface.range_m}; }
};

/// Sighting `index` of a scan.
Sighting sighting_of(const ScanSurfaces& scan, std::size_t scan_index, std::size_t index);

/// Tests many sightings against one feature: the gates on range and bearing, and the weight of
/// each.
class FeatureGauge {
 public:
  FeatureGauge(const EchoFeature& feature, const SurfaceMatchingParams& params);

  /// How far a sighting's range is off, metres; empty where it cannot be of the feature.
  std::optional<double> misfit_m(const Sighting& sighting) const;
  /// What a sighting of that misfit adds to the feature's support, at most 1.
  double weight(const Sighting& sighting, double misfit_m) const;

 private:
  double range_m(const Eigen::Vector2d& from_m) const;
  double bearing_rad(const Eigen::Vector2d& from_m) const;

  EchoFeature feature_;
  Eigen::Vector2d normal_;  ///< Of a wall.
  const SurfaceMatchingParams& params_;
};

/// The angle that the directions span from which a point is seen, radians.
double seen_over_rad(const Eigen::Vector2d& point_m, const std::vector<Sighting>& from);

/// Moves a feature to where it fits its sightings best: least squares over their ranges and
/// bearings (Gauss and Newton). A radius above zero is fitted, too.
EchoFeature fitted(EchoFeature feature,
                   const std::vector<Sighting>& sightings,
                   const SurfaceMatchingParams& params);

}  // namespace echomap::mapping
