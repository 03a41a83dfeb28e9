// SPDX-License-Identifier: MIT
#pragma once

#include <numbers>

namespace echomap::geometry {

/// The same direction in (-pi, pi]; any finite angle in radians.
double wrap_angle(double angle_rad);

/// Signed turn from `from_rad` to `to_rad`, in (-pi, pi].
double angle_between(double from_rad, double to_rad);

/// Once around.
inline constexpr double kFullTurnRad = 2.0 * std::numbers::pi;

/// Degrees to radians and back.
constexpr double radians(double degrees) { return degrees * std::numbers::pi / 180.0; }
constexpr double degrees(double radians) { return radians * 180.0 / std::numbers::pi; }

}  // namespace echomap::geometry
