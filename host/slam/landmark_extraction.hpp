// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "host/mapping/cylinder_detection.hpp"
#include "host/mapping/line_extraction.hpp"
#include "host/sensors/range_scan.hpp"
#include "host/slam/landmark_sighting.hpp"

namespace echomap::slam {

/// Labels of points, by what they are.
inline constexpr int kInnerCorner = 1;  ///< Less than half a turn of floor, as in a room's corner.
inline constexpr int kOuterCorner = 2;  ///< Around the edge of a cupboard.
inline constexpr int kPost = 3;         ///< Stands alone: a leg, a trunk, a spike in the scan.

/// What in a scan is taken for a landmark, and how unsure it is; ours, for a laser.
struct LandmarkExtractionParams {
  /// What is farther is not looked at: there beams are too far apart.
  double max_range_m = 20.0;
  mapping::LineExtractionParams lines{.split_distance_m = 0.09,
                                      .max_gap_m = 0.5,
                                      .point_stddev_m = 0.03,
                                      .min_points = 6,
                                      .min_length_m = 0.5};
  bool with_walls = true;
  double min_wall_m = 1.0;  ///< A shorter line only makes corners.
  /// What a wall is unsure by beyond the noise of its points: it is not quite straight.
  double wall_offset_stddev_m = 0.02;
  double wall_normal_stddev_rad = 0.01;
  bool with_corners = true;
  mapping::WallCornerParams corners;
  double corner_stddev_m = 0.05;
  bool with_posts = true;
  mapping::CylinderDetectionParams posts{
      .radius_m = 0.1, .max_gap_m = 0.15, .min_step_m = 0.5, .width_tolerance_m = 0.1};
  double post_stddev_m = 0.05;
};

/// Walls, corners and posts in a scan of a laser. Throws std::invalid_argument for invalid
/// parameters.
std::vector<LandmarkSighting> extract_landmarks(const sensors::RangeScan& scan,
                                                const LandmarkExtractionParams& params = {});

}  // namespace echomap::slam
