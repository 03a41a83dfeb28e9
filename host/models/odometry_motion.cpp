// SPDX-License-Identifier: MIT
#include "host/models/odometry_motion.hpp"

#include <cmath>
#include <numbers>

#include "host/geometry/angle.hpp"
#include "host/geometry/parameter_validator.hpp"
#include "host/geometry/square.hpp"

namespace echomap::models {

namespace {

constexpr double kMinDriveM = 1e-3;

using geometry::square;

}  // namespace

OdometryStep odometry_step(const geometry::Pose2& T_odom_before,
                           const geometry::Pose2& T_odom_after) {
  const geometry::Pose2 T_before_after = T_odom_before.inverse() * T_odom_after;
  const double turn_rad = T_before_after.heading_rad();
  const double drive_m = T_before_after.position_m().norm();
  if (drive_m < kMinDriveM) {
    return {turn_rad, drive_m, 0.0};
  }
  const double ahead_rad = std::atan2(T_before_after.y_m(), T_before_after.x_m());
  const bool is_backwards = std::abs(ahead_rad) > std::numbers::pi / 2.0;
  const double before_rad =
      is_backwards ? geometry::wrap_angle(ahead_rad + std::numbers::pi) : ahead_rad;
  return {
      before_rad, is_backwards ? -drive_m : drive_m, geometry::angle_between(before_rad, turn_rad)};
}

OdometryMotion::OdometryMotion(const OdometryMotionParams& params) : params_(params) {
  geometry::ParameterValidator("odometry motion")
      .nonnegative_finite("alpha1", params.alpha1)
      .nonnegative_finite("alpha2_rad2_per_m2", params.alpha2_rad2_per_m2)
      .nonnegative_finite("alpha3", params.alpha3)
      .nonnegative_finite("alpha4_m2_per_rad2", params.alpha4_m2_per_rad2)
      .nonnegative_finite("side_slip", params.side_slip);
}

MotionSpread OdometryMotion::spread(const OdometryStep& step) const {
  const double before = square(step.turn_before_rad);
  const double after = square(step.turn_after_rad);
  const double drive = square(step.drive_m);
  const auto turn_rad = [&](double turn) {
    return std::sqrt(params_.alpha1 * turn + params_.alpha2_rad2_per_m2 * drive);
  };
  return {turn_rad(before),
          std::sqrt(params_.alpha3 * drive + params_.alpha4_m2_per_rad2 * (before + after)),
          turn_rad(after),
          std::sqrt(params_.side_slip * drive)};
}

}  // namespace echomap::models
