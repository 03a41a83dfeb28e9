// SPDX-License-Identifier: MIT
#include "host/geometry/angle.hpp"

#include <cmath>

namespace echomap::geometry {

double wrap_angle(double angle_rad) {
  const double wrapped = std::remainder(angle_rad, 2.0 * std::numbers::pi);
  return wrapped <= -std::numbers::pi ? std::numbers::pi : wrapped;
}

double angle_between(double from_rad, double to_rad) { return wrap_angle(to_rad - from_rad); }

}  // namespace echomap::geometry
