// SPDX-License-Identifier: MIT
#include "host/localization/pose_measurement.hpp"

#include <cmath>

#include <Eigen/Cholesky>

#include "host/geometry/angle.hpp"
#include "host/models/landmark_view.hpp"

namespace echomap::localization {

namespace {

bool are_finite(std::initializer_list<double> values) {
  bool finite = true;
  for (const double value : values) {
    finite = finite && std::isfinite(value);
  }
  return finite;
}

std::optional<MeasurementFault> fault(const PoseFix& fix) {
  if (!std::isfinite(fix.stamp_s) || !is_finite(fix.T_map_robot)) {
    return MeasurementFault::kNotFinite;
  }
  return is_covariance(fix.covariance) ? std::nullopt
                                       : std::optional(MeasurementFault::kBadCovariance);
}

std::optional<MeasurementFault> fault(const LandmarkObservation& seen) {
  if (!are_finite({seen.stamp_s, seen.range_m, seen.bearing_rad}) || !seen.landmark_m.allFinite() ||
      !is_finite(seen.T_robot_sensor)) {
    return MeasurementFault::kNotFinite;
  }
  if (seen.range_m <= 0.0) {
    return MeasurementFault::kBadRange;
  }
  const bool sure = are_finite({seen.range_stddev_m, seen.bearing_stddev_rad}) &&
                    seen.range_stddev_m > 0.0 && seen.bearing_stddev_rad > 0.0;
  return sure ? std::nullopt : std::optional(MeasurementFault::kBadCovariance);
}

std::optional<LinearMeasurement> linear(const PoseFix& fix, const geometry::Pose2& T_map_robot) {
  const Eigen::Vector2d off_m = fix.T_map_robot.position_m() - T_map_robot.position_m();
  const double off_rad =
      geometry::angle_between(T_map_robot.heading_rad(), fix.T_map_robot.heading_rad());
  return LinearMeasurement{
      Eigen::Vector3d(off_m.x(), off_m.y(), off_rad), Eigen::Matrix3d::Identity(), fix.covariance};
}

std::optional<LinearMeasurement> linear(const LandmarkObservation& seen,
                                        const geometry::Pose2& T_map_robot) {
  const auto view = models::landmark_view(T_map_robot, seen.T_robot_sensor, seen.landmark_m);
  if (!view) {
    return std::nullopt;
  }
  const Eigen::Vector2d variance(seen.range_stddev_m * seen.range_stddev_m,
                                 seen.bearing_stddev_rad * seen.bearing_stddev_rad);
  return LinearMeasurement{
      Eigen::Vector2d(seen.range_m - view->range_m,
                      geometry::angle_between(view->bearing_rad, seen.bearing_rad)),
      view->jacobian_pose,
      variance.asDiagonal().toDenseMatrix()};
}

/// S of Algorithm 1, line 4.
LinearMeasurement::Matrix innovation_covariance(const PoseGaussian& belief,
                                                const LinearMeasurement& measurement) {
  return measurement.jacobian_pose * belief.covariance * measurement.jacobian_pose.transpose() +
         measurement.noise;
}

}  // namespace

std::optional<MeasurementFault> fault_of(const PoseMeasurement& measurement) {
  return std::visit([](const auto& kind) { return fault(kind); }, measurement);
}

std::optional<LinearMeasurement> linearized(const PoseMeasurement& measurement,
                                            const geometry::Pose2& T_map_robot) {
  return std::visit([&](const auto& kind) { return linear(kind, T_map_robot); }, measurement);
}

double squared_distance(const PoseGaussian& belief, const LinearMeasurement& measurement) {
  const LinearMeasurement::Matrix covariance = innovation_covariance(belief, measurement);
  return measurement.innovation.dot(covariance.llt().solve(measurement.innovation));
}

PoseGaussian corrected(const PoseGaussian& belief, const LinearMeasurement& measurement) {
  const LinearMeasurement::Matrix covariance = innovation_covariance(belief, measurement);
  const LinearMeasurement::Jacobian gain_transposed =
      covariance.llt().solve(measurement.jacobian_pose * belief.covariance);
  const Eigen::Vector3d step = gain_transposed.transpose() * measurement.innovation;
  const Eigen::Matrix3d left =
      Eigen::Matrix3d::Identity() - gain_transposed.transpose() * measurement.jacobian_pose;
  const Eigen::Matrix3d after = left * belief.covariance * left.transpose() +
                                gain_transposed.transpose() * measurement.noise * gain_transposed;
  return {geometry::Pose2(belief.T_map_robot.x_m() + step.x(),
                          belief.T_map_robot.y_m() + step.y(),
                          belief.T_map_robot.heading_rad() + step.z()),
          0.5 * (after + after.transpose())};
}

}  // namespace echomap::localization
