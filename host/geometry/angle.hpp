// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <numbers>

namespace echomap::geometry {

/// Once around.
inline constexpr double kFullTurnRad = 2.0 * std::numbers::pi;

/// The same direction in (-pi, pi]; any finite angle in radians.
inline double wrap_angle(double angle_rad) {
  // Most angles lie within one turn more, where a subtraction is exact, and fast.
  double wrapped = angle_rad;
  if (std::abs(angle_rad) >= 1.5 * kFullTurnRad) {
    wrapped = std::remainder(angle_rad, kFullTurnRad);
  } else if (std::abs(angle_rad) > std::numbers::pi) {
    wrapped = angle_rad - std::copysign(kFullTurnRad, angle_rad);
  }
  return wrapped <= -std::numbers::pi ? std::numbers::pi : wrapped;
}

/// Signed turn from `from_rad` to `to_rad`, in (-pi, pi].
inline double angle_between(double from_rad, double to_rad) {
  return wrap_angle(to_rad - from_rad);
}

/// Degrees to radians and back.
constexpr double radians(double degrees) { return degrees * std::numbers::pi / 180.0; }
constexpr double degrees(double radians) { return radians * 180.0 / std::numbers::pi; }

}  // namespace echomap::geometry
