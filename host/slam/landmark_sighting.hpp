// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>

#include <Eigen/Core>

#include "host/geometry/pose2.hpp"
#include "host/models/landmark_view.hpp"

namespace echomap::slam {

/// The sensor model knows the kinds of landmarks.
using models::LandmarkKind;

/// A landmark as a sensor has seen it.
struct LandmarkSighting {
  LandmarkKind kind = LandmarkKind::kPoint;
  /// In the sensor's frame: a length and an angle, by the kind.
  Eigen::Vector2d value = Eigen::Vector2d::Zero();
  /// Covariance of the value.
  Eigen::Matrix2d noise = Eigen::Matrix2d::Identity();
  geometry::Pose2 T_robot_sensor;
  /// Of a wall: where along it the seen piece begins and ends, in metres from the foot of the
  /// sensor's perpendicular, positive counter-clockwise.
  double along_from_m = 0.0;
  double along_to_m = 0.0;
  /// A sighting is only ever of a landmark with the same label, as the sort of a corner.
  int label = 0;
  std::size_t robot = 0;  ///< Who has seen it, of a team.
};

/// A value as it is expected, and how it changes with the robot's x, y, heading and with the two
/// numbers of the landmark.
struct ExpectedSighting {
  Eigen::Vector2d value = Eigen::Vector2d::Zero();
  Eigen::Matrix<double, 2, 3> jacobian_pose = Eigen::Matrix<double, 2, 3>::Zero();
  Eigen::Matrix2d jacobian_landmark = Eigen::Matrix2d::Zero();
};

/// How a landmark is seen from a pose (Thrun, Burgard and Fox 2005, table 10.1, lines 11 to 15, for
/// points; Garulli et al. 2005 for walls). Empty for a point that the sensor stands on.
std::optional<ExpectedSighting> expected_sighting(LandmarkKind kind,
                                                  const Eigen::Vector2d& landmark,
                                                  const geometry::Pose2& T_map_robot,
                                                  const geometry::Pose2& T_robot_sensor);

/// A landmark where a sighting says that it is, and how that changes with the robot's x, y, heading
/// and with the value that was seen.
struct PlacedLandmark {
  Eigen::Vector2d landmark = Eigen::Vector2d::Zero();
  Eigen::Matrix<double, 2, 3> jacobian_pose = Eigen::Matrix<double, 2, 3>::Zero();
  Eigen::Matrix2d by_value = Eigen::Matrix2d::Zero();
};

/// Turns a sighting from a pose around (table 10.1, line 9).
PlacedLandmark placed_landmark(const LandmarkSighting& sighting,
                               const geometry::Pose2& T_map_robot);

/// What was seen less what was expected; the angle in (-pi, pi].
Eigen::Vector2d innovation(const Eigen::Vector2d& seen, const Eigen::Vector2d& expected);

}  // namespace echomap::slam
