// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <variant>

#include <Eigen/Core>

#include "host/localization/pose_gaussian.hpp"

namespace echomap::localization {

/// Where something outside, as a camera overhead, has seen the robot.
struct PoseFix {
  double stamp_s = 0.0;  ///< When it was seen, on the clock of the odometry.
  geometry::Pose2 T_map_robot;
  /// Of x, y (m) and heading (rad).
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();
};

/// A landmark of the map, known which, as a sensor of the robot has seen it.
struct LandmarkObservation {
  double stamp_s = 0.0;
  Eigen::Vector2d landmark_m = Eigen::Vector2d::Zero();  ///< In the map.
  geometry::Pose2 T_robot_sensor{};
  double range_m = 0.0;
  double bearing_rad = 0.0;
  double range_stddev_m = 0.1;
  double bearing_stddev_rad = 0.05;
};

/// What a filter of poses can be told beside its odometry.
using PoseMeasurement = std::variant<PoseFix, LandmarkObservation>;

/// What is wrong with a measurement in itself.
enum class MeasurementFault : std::uint8_t {
  kNotFinite,
  kBadRange,       ///< A range that is not above 0.
  kBadCovariance,  ///< Not symmetric and positive definite, or a deviation that is not above 0.
};

/// The first of its faults; empty where it has none.
std::optional<MeasurementFault> fault_of(const PoseMeasurement& measurement);

/// A measurement as a linear function of the pose around a given one: two or three numbers.
struct LinearMeasurement {
  using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 3, 1>;
  using Jacobian = Eigen::Matrix<double, Eigen::Dynamic, 3, 0, 3, 3>;
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 3, 3>;

  Vector innovation;       ///< What was measured less what was to be expected.
  Jacobian jacobian_pose;  ///< H.
  Matrix noise;            ///< V R V^T.
};

/// Empty where a landmark lies under the sensor.
std::optional<LinearMeasurement> linearized(const PoseMeasurement& measurement,
                                            const geometry::Pose2& T_map_robot);

/// Squared Mahalanobis distance of the innovation: chi square with as many degrees of freedom as
/// the measurement has numbers.
double squared_distance(const PoseGaussian& belief, const LinearMeasurement& measurement);

/// The belief that knows the measurement (Mahmood and Ridao 2017, Algorithm 1, lines 4 to 6; the
/// covariance in Joseph's form, which stays positive definite).
PoseGaussian corrected(const PoseGaussian& belief, const LinearMeasurement& measurement);

}  // namespace echomap::localization
