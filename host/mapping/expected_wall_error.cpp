// SPDX-License-Identifier: MIT
#include "host/mapping/expected_wall_error.hpp"

#include <cmath>

#include "host/geometry/square.hpp"

namespace echomap::mapping {
namespace {

/// Of a wall right at the start.
constexpr double kBaseErrorM = 0.03;
/// SLAM's standard deviation grows as if all its scans erred alike; maps turn by so much of it.
constexpr double kHeadingShare = 0.25;
constexpr double kP90 = 2.0;

}  // namespace

std::optional<ExpectedWallError> expected_wall_error(const RasterMap& map,
                                                     double heading_stddev_rad) {
  const auto walls_m = centers_m(map, CellState::kOccupied);
  if (walls_m.empty() || !(heading_stddev_rad > 0.0) || !std::isfinite(heading_stddev_rad)) {
    return std::nullopt;
  }
  double squares_m2 = 0.0;
  for (const Eigen::Vector2d& wall_m : walls_m) {
    squares_m2 += wall_m.squaredNorm();
  }
  const double distance_m = std::sqrt(squares_m2 / static_cast<double>(walls_m.size()));
  const double median_m =
      std::sqrt(geometry::square(kBaseErrorM) +
                geometry::square(kHeadingShare * heading_stddev_rad * distance_m));
  return ExpectedWallError{median_m, kP90 * median_m};
}

}  // namespace echomap::mapping
