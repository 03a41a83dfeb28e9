// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "host/mapping/echo_feature.hpp"
#include "host/mapping/sonar_surfaces.hpp"

namespace echomap::mapping {

/// When sightings from several stops are taken for one wall or post.
struct SurfaceMatchingParams {
  /// A sighting belongs to a feature when its range is off by at most this: 2 sigma of the mean of
  /// a few readings plus the odometry's drift from stop to stop.
  double range_tolerance_m = 0.05;
  /// ... and its bearing by at most these. The range of a sighting is good to a centimetre or two,
  /// its bearing only to several degrees, where a region is cut short on one side.
  double wall_bearing_tolerance_rad = 0.35;
  double post_bearing_tolerance_rad = 0.26;
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
};

/// A straight wall that several stops agree on: the points p with n . p = offset, n the unit vector
/// at `normal_rad`, and with n_left . p in one of the pieces.
struct MatchedWall {
  double normal_rad = 0.0;
  double offset_m = 0.0;
  struct Piece {
    double from_m = 0.0;
    double to_m = 0.0;
  };
  /// In order, apart from each other.
  std::vector<Piece> pieces;
};

/// A feature and the sightings that it was made of.
struct MatchedFeature {
  EchoFeature feature;
  /// Scan and index of the surface in it; at most one of each scan.
  std::vector<std::pair<std::size_t, std::size_t>> supporters;
};

/// What all stops together have seen, in the map frame.
struct MatchedSurfaces {
  /// As given, with bearings and ranges of the matched surfaces made better.
  std::vector<ScanSurfaces> scans;
  std::vector<MatchedWall> walls;
  /// Posts and corners.
  std::vector<Eigen::Vector2d> posts_m;
  /// Walls and posts in the order in which they were found, the best supported first.
  std::vector<MatchedFeature> features;
};

/// Finds what several stops have seen: each pair of sightings proposes walls and posts, the one
/// that most sightings support wins and takes them, and again (in the manner of Tardos et al.
/// 2002). Ranges from two places fix a surface much better than the bearing from one.
MatchedSurfaces match_surfaces(std::vector<ScanSurfaces> scans,
                               const SurfaceMatchingParams& params);

}  // namespace echomap::mapping
