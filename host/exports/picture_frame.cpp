// SPDX-License-Identifier: MIT
#include "host/exports/picture_frame.hpp"

#include <cmath>

#include <Eigen/Geometry>

#include "host/geometry/unit_vector.hpp"

namespace echomap::exports {
namespace {

using Box = Eigen::AlignedBox2d;
using mapping::CellState;
using mapping::RasterMap;

/// Less is drawn along the axes: it could not be seen.
constexpr double kMinTurnRad = 1e-3;

Eigen::Vector2d turned(const Eigen::Vector2d& point_m, double turn_rad) {
  const Eigen::Vector2d x_axis = geometry::unit_vector(turn_rad);
  return point_m.x() * x_axis + point_m.y() * geometry::perpendicular(x_axis);
}

Box whole(const RasterMap& map) {
  return {map.origin_m(),
          map.origin_m() + map.resolution_m() * Eigen::Vector2d(map.columns(), map.rows())};
}

/// Of the middles of the cells, in the picture's axes.
Box known(const RasterMap& map, const PictureFrame& frame) {
  Box box;
  for (const CellState state : {CellState::kFree, CellState::kOccupied}) {
    for (const Eigen::Vector2d& center_m : mapping::centers_m(map, state)) {
      box.extend(frame.in_picture_m(center_m));
    }
  }
  const Eigen::Vector2d margin_m = Eigen::Vector2d::Constant(2.0 * map.resolution_m());
  return box.isEmpty() ? box : Box(box.min() - margin_m, box.max() + margin_m);
}

}  // namespace

Eigen::Vector2d PictureFrame::in_picture_m(const Eigen::Vector2d& point_m) const {
  return turn_rad == 0.0 ? point_m : turned(point_m, -turn_rad);
}

Eigen::Vector2d PictureFrame::in_map_m(const Eigen::Vector2d& picture_m) const {
  return turn_rad == 0.0 ? picture_m : turned(picture_m, turn_rad);
}

PictureFrame frame_of(const RasterMap& map,
                      double turn_rad,
                      const std::vector<Eigen::Vector2d>& points_m) {
  PictureFrame frame;
  frame.turn_rad = std::abs(turn_rad) < kMinTurnRad ? 0.0 : turn_rad;
  Box box = frame.turn_rad == 0.0 ? whole(map) : known(map, frame);
  const Eigen::Vector2d origin_m = box.isEmpty() ? Eigen::Vector2d(map.origin_m()) : box.min();
  box.extend(origin_m);
  for (const Eigen::Vector2d& point_m : points_m) {
    box.extend(frame.in_picture_m(point_m));
  }
  const double cell_m = map.resolution_m();
  // What is a whole number but for rounding stays that number.
  const auto cells_below = [&](double length_m) { return std::floor(length_m / cell_m + 1e-6); };
  const auto cells_above = [&](double length_m) { return std::ceil(length_m / cell_m - 1e-6); };
  const Eigen::Vector2d low = (box.min() - origin_m).unaryExpr(cells_below);
  const Eigen::Vector2d high = (box.max() - origin_m).unaryExpr(cells_above);
  frame.low_m = origin_m + cell_m * low;
  frame.size_m = cell_m * (high - low).cwiseMax(1.0);
  return frame;
}

}  // namespace echomap::exports
