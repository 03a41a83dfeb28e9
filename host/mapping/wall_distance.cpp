// SPDX-License-Identifier: MIT
#include "host/mapping/wall_distance.hpp"

#include <cmath>

namespace echomap::mapping {
namespace {

RasterMap with_margin(const RasterMap& map, double max_m) {
  const int margin = static_cast<int>(std::ceil(max_m / map.resolution_m()));
  return cut_out(map, {{-margin, -margin}, {map.columns() - 1 + margin, map.rows() - 1 + margin}});
}

}  // namespace

WallDistance::WallDistance(const RasterMap& map, double max_m)
    : max_m_(max_m), field_(with_margin(map, max_m), max_m) {}

double WallDistance::at_m(const Eigen::Vector2d& point_m) const {
  const Eigen::Vector2d place =
      (point_m - field_.origin_m()) / field_.resolution_m() - Eigen::Vector2d(0.5, 0.5);
  const Eigen::Vector2d low = place.array().floor();
  const bool inside = low.x() >= 0.0 && low.y() >= 0.0 && low.x() + 2.0 <= field_.columns() &&
                      low.y() + 2.0 <= field_.rows();
  if (!inside) {
    return max_m_;
  }
  const auto x = static_cast<int>(low.x());
  const auto y = static_cast<int>(low.y());
  const Eigen::Vector2d share = place - low;
  const auto along = [&](int row) {
    return (1.0 - share.x()) * field_.distance_cells({x, row}) +
           share.x() * field_.distance_cells({x + 1, row});
  };
  return field_.resolution_m() * ((1.0 - share.y()) * along(y) + share.y() * along(y + 1));
}

}  // namespace echomap::mapping
