// SPDX-License-Identifier: MIT
#include "host/geometry/angle.hpp"

#include <cmath>

namespace echomap::geometry {

double wrap_angle(double angle_rad) {
  // Most angles lie within one turn more, where a subtraction is exact, and fast.
  double wrapped = angle_rad;
  if (std::abs(angle_rad) >= 1.5 * kFullTurnRad) {
    wrapped = std::remainder(angle_rad, kFullTurnRad);
  } else if (std::abs(angle_rad) > std::numbers::pi) {
    wrapped = angle_rad - std::copysign(kFullTurnRad, angle_rad);
  }
  return wrapped <= -std::numbers::pi ? std::numbers::pi : wrapped;
}

double angle_between(double from_rad, double to_rad) { return wrap_angle(to_rad - from_rad); }

}  // namespace echomap::geometry
