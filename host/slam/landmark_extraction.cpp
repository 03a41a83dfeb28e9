// SPDX-License-Identifier: MIT
#include "host/slam/landmark_extraction.hpp"

#include <algorithm>
#include <cmath>

#include "host/geometry/unit_vector.hpp"
#include "host/sensors/range_scan.hpp"

namespace echomap::slam {

namespace {

std::vector<Eigen::Vector2d> points_of(const sensors::RangeScan& scan, double max_range_m) {
  sensors::RangeScan at_sensor{{}, {}, scan.beams};
  return sensors::end_points_m(at_sensor, max_range_m);
}

LandmarkSighting wall_sighting(const mapping::FittedLine& line,
                               const LandmarkExtractionParams& params) {
  const Eigen::Vector2d along = geometry::perpendicular(geometry::unit_vector(line.normal_rad));
  const double from_m = along.dot(line.segment.from_m);
  const double to_m = along.dot(line.segment.to_m);
  const Eigen::Vector2d own_stddev(params.wall_offset_stddev_m, params.wall_normal_stddev_rad);
  LandmarkSighting wall;
  wall.kind = LandmarkKind::kWall;
  wall.value = {line.offset_m, line.normal_rad};
  wall.noise = line.covariance + Eigen::Matrix2d(own_stddev.cwiseAbs2().asDiagonal());
  wall.along_from_m = std::min(from_m, to_m);
  wall.along_to_m = std::max(from_m, to_m);
  return wall;
}

LandmarkSighting point_sighting(const Eigen::Vector2d& position_m, double stddev_m, int label) {
  const double range_m = position_m.norm();
  LandmarkSighting point;
  point.value = {range_m, std::atan2(position_m.y(), position_m.x())};
  point.noise =
      Eigen::Vector2d(stddev_m * stddev_m, stddev_m * stddev_m / (range_m * range_m)).asDiagonal();
  point.label = label;
  return point;
}

int label_of(mapping::CornerKind kind) {
  return kind == mapping::CornerKind::kNonReflex ? kInnerCorner : kOuterCorner;
}

}  // namespace

std::vector<LandmarkSighting> extract_landmarks(const sensors::RangeScan& scan,
                                                const LandmarkExtractionParams& params) {
  const std::vector<Eigen::Vector2d> points_m = points_of(scan, params.max_range_m);
  const auto lines = mapping::extract_lines(points_m, params.lines);
  std::vector<LandmarkSighting> sightings;
  for (const mapping::FittedLine& line : lines) {
    if (params.with_walls && line.segment.length_m() >= params.min_wall_m) {
      sightings.push_back(wall_sighting(line, params));
    }
  }
  if (params.with_corners) {
    for (const auto& corner : mapping::find_corners(lines, false, params.corners)) {
      sightings.push_back(
          point_sighting(corner.position_m, params.corner_stddev_m, label_of(corner.kind)));
    }
  }
  if (params.with_posts) {
    for (const Eigen::Vector2d& post_m : mapping::find_cylinders(points_m, params.posts)) {
      sightings.push_back(point_sighting(post_m, params.post_stddev_m, kPost));
    }
  }
  for (LandmarkSighting& sighting : sightings) {
    sighting.T_robot_sensor = scan.T_robot_sensor;
  }
  return sightings;
}

}  // namespace echomap::slam
