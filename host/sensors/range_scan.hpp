// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "host/geometry/pose2.hpp"

namespace echomap::sensors {

/// A range in one direction. `range_m` is empty where nothing answered.
struct Beam {
  double bearing_rad = 0.0;  ///< Counter-clockwise; in the frame that its holder names.
  std::optional<double> range_m;

  bool operator==(const Beam&) const = default;
};

/// Ranges that were taken together from one place: a laser scan, a ring of sonars, one ping.
struct RangeScan {
  std::optional<double> stamp_s;
  geometry::Pose2 T_robot_sensor;
  std::vector<Beam> beams;      ///< Bearings in the sensor's frame.
  double beam_width_rad = 0.0;  ///< The whole cone of a beam; 0 for a laser.
  double max_range_m = 0.0;     ///< What is as far as this or farther does not answer.
  /// Light is swallowed as easily as it gets lost: its silence says nothing. Sound that nothing
  /// answers speaks for free floor.
  bool is_light = false;
};

/// The range that a sensor reports; empty for zero, below, and `max_range_m` or more.
inline std::optional<double> returned_range_m(double range_m, double max_range_m) {
  const bool is_return = range_m > 0.0 && range_m < max_range_m;
  return is_return ? std::optional(range_m) : std::nullopt;
}

/// Where the answers of a scan lie, on the axes of their beams, in the robot's frame. In the order
/// of the beams; those without answer, or with one beyond `max_range_m`, are left out.
std::vector<Eigen::Vector2d> end_points_m(const RangeScan& scan, double max_range_m);

/// The same points in another frame.
std::vector<Eigen::Vector2d> in_frame_a_m(const geometry::Pose2& T_a_b,
                                          std::span<const Eigen::Vector2d> points_b_m);

}  // namespace echomap::sensors
