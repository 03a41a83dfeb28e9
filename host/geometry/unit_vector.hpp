// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include <Eigen/Core>

namespace echomap::geometry {

/// The vector of length 1 that points to a bearing, counter-clockwise from the x axis.
inline Eigen::Vector2d unit_vector(double bearing_rad) {
  return {std::cos(bearing_rad), std::sin(bearing_rad)};
}

/// The vector turned counter-clockwise by a quarter turn.
inline Eigen::Vector2d perpendicular(const Eigen::Vector2d& vector) {
  return {-vector.y(), vector.x()};
}

}  // namespace echomap::geometry
