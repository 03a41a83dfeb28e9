// SPDX-License-Identifier: MIT
#include "host/mapping/expected_wall_error.hpp"

#include <cmath>

#include "host/geometry/square.hpp"

namespace echomap::mapping {
namespace {

/// Of a wall right at the start.
constexpr double kNearWallM = 0.03;
/// SLAM's doubt grows with each matched scan as if all erred alike; maps turn by so much of it.
constexpr double kHeadingShare = 0.25;
constexpr double kNineInTen = 2.0;

}  // namespace

std::optional<ExpectedWallError> expected_wall_error(const RasterMap& map,
                                                     double heading_stddev_rad) {
  const auto walls_m = centers_m(map, CellState::kOccupied);
  if (walls_m.empty()) {
    return std::nullopt;
  }
  double squares_m2 = 0.0;
  for (const Eigen::Vector2d& wall_m : walls_m) {
    squares_m2 += wall_m.squaredNorm();
  }
  const double extent_m = std::sqrt(squares_m2 / static_cast<double>(walls_m.size()));
  const double median_m =
      std::sqrt(geometry::square(kNearWallM) +
                geometry::square(kHeadingShare * heading_stddev_rad * extent_m));
  return ExpectedWallError{median_m, kNineInTen * median_m};
}

}  // namespace echomap::mapping
