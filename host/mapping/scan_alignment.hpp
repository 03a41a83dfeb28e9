// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "host/geometry/pose2.hpp"
#include "host/mapping/sonar_surfaces.hpp"
#include "host/mapping/surface_matching.hpp"

namespace echomap::mapping {

/// How far odometry, or SLAM, is trusted from one stop to the next. The standard deviations are
/// those of a small robot on rubber tyres; they only have to be of the right size.
struct ScanAlignmentParams {
  double heading_stddev_rad = 0.03;        ///< Of the turns at a stop.
  double heading_stddev_rad_per_m = 0.03;  ///< Of the way between two stops.
  double position_stddev_m = 0.005;
  double position_stddev_per_m = 0.01;
  /// Of a surface's bearing: 4 to 6 degrees in simulated rooms. That of a feature comes from
  /// ranges, but only bearings tell which way a scan was turned.
  double bearing_stddev_rad = 0.09;
  /// Sightings of one feature by fewer stops say too little of where the stops were.
  std::size_t min_supporters = 3;
  /// Matching and correcting are done in turns.
  int rounds = 3;
};

/// Scans where they agree.
struct AlignedScans {
  std::vector<ScanSurfaces> scans;
  /// How each was moved; the robot goes with the last one.
  std::vector<geometry::Pose2> T_map_placed;
};

/// Corrects where `scans`, placed by odometry (or by SLAM), were taken, so that they agree with
/// what they have seen together: least squares over the stops' poses and the matched features, with
/// the odometry between the stops as a prior (graph SLAM on features; Thrun, Burgard and Fox 2005,
/// chapter 11). The first scan stays. Scans that share nothing with others keep to their odometry.
AlignedScans align_scans(const std::vector<ScanSurfaces>& scans,
                         const SurfaceMatchingParams& matching,
                         const ScanAlignmentParams& params);

}  // namespace echomap::mapping
