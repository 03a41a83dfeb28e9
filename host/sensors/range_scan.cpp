// SPDX-License-Identifier: MIT
#include "host/sensors/range_scan.hpp"

#include "host/geometry/unit_vector.hpp"

namespace echomap::sensors {

std::vector<Eigen::Vector2d> end_points_m(const RangeScan& scan, double max_range_m) {
  std::vector<Eigen::Vector2d> points_m;
  points_m.reserve(scan.beams.size());
  for (const Beam& beam : scan.beams) {
    if (beam.range_m && *beam.range_m <= max_range_m) {
      points_m.push_back(*beam.range_m * geometry::unit_vector(beam.bearing_rad));
    }
  }
  return in_frame_a_m(scan.T_robot_sensor, points_m);
}

std::vector<Eigen::Vector2d> in_frame_a_m(const geometry::Pose2& T_a_b,
                                          std::span<const Eigen::Vector2d> points_b_m) {
  const Eigen::Vector2d ahead = geometry::unit_vector(T_a_b.heading_rad());
  std::vector<Eigen::Vector2d> points_a_m;
  points_a_m.reserve(points_b_m.size());
  for (const Eigen::Vector2d& point_m : points_b_m) {
    points_a_m.emplace_back(T_a_b.x_m() + point_m.x() * ahead.x() - point_m.y() * ahead.y(),
                            T_a_b.y_m() + point_m.x() * ahead.y() + point_m.y() * ahead.x());
  }
  return points_a_m;
}

}  // namespace echomap::sensors
