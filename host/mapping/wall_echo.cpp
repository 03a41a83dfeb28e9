// SPDX-License-Identifier: MIT
#include "host/mapping/wall_echo.hpp"

#include <algorithm>
#include <cmath>

#include "host/geometry/angle.hpp"
#include "host/geometry/unit_vector.hpp"

namespace echomap::mapping {

namespace {

const double kMaxIncidenceRad = geometry::radians(75.0);

}  // namespace

Eigen::Vector2d Echo::middle_m() const {
  return sensor_m + range_m * geometry::unit_vector(axis_rad);
}

WallView view_of_wall(const Echo& echo, const WallLine& line) {
  const Eigen::Vector2d normal = geometry::unit_vector(line.normal_rad);
  const Eigen::Vector2d left = geometry::perpendicular(normal);
  const double distance_m = line.offset_m - normal.dot(echo.sensor_m);
  const double off_axis_rad = geometry::angle_between(echo.axis_rad, line.normal_rad);
  const double in_beam_rad =
      std::clamp(off_axis_rad, -echo.beam_half_angle_rad, echo.beam_half_angle_rad);
  const double slant_rad =
      std::clamp(off_axis_rad - in_beam_rad, -kMaxIncidenceRad, kMaxIncidenceRad);
  const double cosine = std::cos(slant_rad);
  const double by_slant = distance_m * std::sin(slant_rad) / (cosine * cosine);
  return {distance_m / cosine,
          {-left.dot(echo.sensor_m) / cosine + by_slant, 1.0 / cosine},
          echo.axis_rad + in_beam_rad};
}

WallLine wall_through(const Echo& echo, double normal_rad) {
  const WallView at_origin = view_of_wall(echo, {normal_rad, 0.0});
  return {normal_rad, (echo.range_m - at_origin.range_m) / at_origin.by_line[1]};
}

}  // namespace echomap::mapping
