// SPDX-License-Identifier: MIT
#include "host/datasets/ros_observations.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "host/files/atomic_file.hpp"
#include "host/geometry/angle.hpp"

namespace echomap::datasets {
namespace {

/// What the models of cones hold for: nobody reads anything from wider or longer ones.
constexpr double kMaxBeamWidthRad = std::numbers::pi / 2.0;
constexpr double kMaxConeRangeM = 20.0;
/// What is farther away is damage, and poses composed of it would be no numbers.
constexpr double kMaxPositionM = 1e9;

double require_finite(const char* field, double value) {
  if (!std::isfinite(value)) {
    throw files::FileError(std::string(field) + " is not a finite number");
  }
  return value;
}

double require_positive(const char* field, double value) {
  if (!(require_finite(field, value) > 0.0)) {
    throw files::FileError(std::string(field) + " = " + std::to_string(value) + " is not above 0");
  }
  return value;
}

SpatialPose spatial_pose(double x_m, double y_m, double z_m, const ros_messages::Quaternion& turn) {
  if (!(std::abs(x_m) + std::abs(y_m) + std::abs(z_m) < kMaxPositionM)) {
    throw files::FileError("the position is not within 1e9 m");
  }
  const Eigen::Quaterniond rotation(turn.w, turn.x, turn.y, turn.z);
  const double length = rotation.norm();
  if (!(std::abs(length - 1.0) < 0.1)) {
    throw files::FileError("the quaternion of the orientation has length " +
                           std::to_string(length) + ", not 1");
  }
  return {{x_m, y_m, z_m}, rotation.normalized()};
}

std::optional<double> range_within(double range_m, double min_m, double max_m) {
  // A limit that is not a number limits nothing.
  return range_m < min_m ? std::nullopt : sensors::returned_range_m(range_m, max_m);
}

}  // namespace

double seconds_of(const ros_messages::Time& stamp) {
  return static_cast<double>(stamp.sec) + 1e-9 * static_cast<double>(stamp.nanosec);
}

std::string frame_name(std::string_view frame_id) {
  return std::string(frame_id.starts_with('/') ? frame_id.substr(1) : frame_id);
}

SpatialPose spatial_pose(const ros_messages::Pose& pose) {
  return spatial_pose(pose.position.x, pose.position.y, pose.position.z, pose.orientation);
}

SpatialPose spatial_pose(const ros_messages::Transform& transform) {
  const ros_messages::Vector3& offset_m = transform.translation;
  return spatial_pose(offset_m.x, offset_m.y, offset_m.z, transform.rotation);
}

geometry::Pose2 planar_pose(const SpatialPose& pose) {
  const Eigen::Vector3d forward = pose.rotation * Eigen::Vector3d::UnitX();
  return {pose.position_m.x(), pose.position_m.y(), std::atan2(forward.y(), forward.x())};
}

sensors::RangeScan scan_of(const ros_messages::Range& range) {
  sensors::RangeScan scan;
  scan.max_range_m = std::min(require_positive("max_range", range.max_range), kMaxConeRangeM);
  scan.beam_width_rad = require_finite("field_of_view", range.field_of_view);
  if (scan.beam_width_rad < 0.0 || scan.beam_width_rad > kMaxBeamWidthRad) {
    throw files::FileError("field_of_view = " + std::to_string(scan.beam_width_rad) +
                           " is outside of 0 .. pi/2");
  }
  scan.is_light = range.radiation_type == ros_messages::Range::kInfrared;
  scan.beams = {{0.0, range_within(range.range, range.min_range, scan.max_range_m)}};
  return scan;
}

sensors::RangeScan scan_of(const ros_messages::LaserScan& sweep) {
  const double first_rad = require_finite("angle_min", sweep.angle_min);
  const double step_rad = require_finite("angle_increment", sweep.angle_increment);
  sensors::RangeScan scan;
  scan.max_range_m = require_positive("range_max", sweep.range_max);
  scan.is_light = true;
  scan.beams.reserve(sweep.ranges.size());
  for (const float range_m : sweep.ranges) {
    const double bearing_rad = first_rad + static_cast<double>(scan.beams.size()) * step_rad;
    scan.beams.push_back({geometry::wrap_angle(require_finite("a bearing", bearing_rad)),
                          range_within(range_m, sweep.range_min, sweep.range_max)});
  }
  return scan;
}

bool place_on_robot(const SpatialPose& T_robot_sensor, sensors::RangeScan& scan) {
  const double upright = (T_robot_sensor.rotation * Eigen::Vector3d::UnitZ()).z();
  const double forward_z = (T_robot_sensor.rotation * Eigen::Vector3d::UnitX()).z();
  const bool is_single = scan.beams.size() == 1 && scan.beams.front().bearing_rad == 0.0;
  // A single beam along x may be turned about itself.
  const bool is_level = is_single ? std::abs(forward_z) <= std::sin(kMaxTiltRad)
                                  : std::abs(upright) >= std::cos(kMaxTiltRad);
  if (upright < 0.0) {
    for (sensors::Beam& beam : scan.beams) {
      beam.bearing_rad = -beam.bearing_rad;
    }
  }
  scan.T_robot_sensor = planar_pose(T_robot_sensor);
  return is_level;
}

}  // namespace echomap::datasets
