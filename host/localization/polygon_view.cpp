// SPDX-License-Identifier: MIT
#include "host/localization/polygon_view.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "host/geometry/parameter_validator.hpp"
#include "host/geometry/unit_vector.hpp"

namespace echomap::localization {

namespace {

const PolygonViewParams& validated(const PolygonViewParams& params) {
  geometry::ParameterValidator("polygon view")
      .positive("max_range_m", params.max_range_m)
      .positive("oblique_above_rad", params.oblique_above_rad);
  return params;
}

void add_sides(const geometry::Polygon& ring_m, std::vector<geometry::Segment>& walls) {
  for (std::size_t i = 0; i < ring_m.size(); ++i) {
    walls.push_back(geometry::side(ring_m, i));
  }
}

struct Hit {
  double range_m = std::numeric_limits<double>::infinity();
  const geometry::Segment* wall = nullptr;
};

Hit first_hit(const std::vector<geometry::Segment>& walls,
              const Eigen::Vector2d& from_m,
              const Eigen::Vector2d& direction) {
  Hit first;
  for (const geometry::Segment& wall : walls) {
    const std::optional<double> range_m = geometry::ray_distance_m(from_m, direction, wall);
    if (range_m && *range_m < first.range_m) {
      first = {*range_m, &wall};
    }
  }
  return first;
}

}  // namespace

PolygonView::PolygonView(const mapping::PolygonMap& map, const PolygonViewParams& params)
    : params_(validated(params)), outline_(map.outline_m()) {
  add_sides(map.outline_m(), walls_);
  for (const geometry::Polygon& hole_m : map.holes_m()) {
    add_sides(hole_m, walls_);
    holes_.emplace_back(hole_m);
  }
}

models::ExpectedRange PolygonView::expected(const geometry::Pose2& T_map_sensor) const {
  const Eigen::Vector2d direction = geometry::unit_vector(T_map_sensor.heading_rad());
  const Hit hit = first_hit(walls_, T_map_sensor.position_m(), direction);
  if (hit.wall == nullptr || hit.range_m >= params_.max_range_m) {
    return {};
  }
  const double straightness = std::abs(geometry::left_normal(*hit.wall).dot(direction));
  return {hit.range_m, straightness < std::cos(params_.oblique_above_rad)};
}

models::WallAhead PolygonView::wall_ahead(const geometry::Pose2& T_map_robot,
                                          double radius_m) const {
  models::WallAhead ahead;
  ahead.gap_m = std::numeric_limits<double>::infinity();
  const geometry::Pose2 T_robot_map = T_map_robot.inverse();
  for (const geometry::Segment& wall : walls_) {
    const Eigen::Vector2d nearest_m =
        T_robot_map * geometry::nearest_point(wall, T_map_robot.position_m());
    const double gap_m = nearest_m.norm() - radius_m;
    if (nearest_m.x() > 0.0 && gap_m < ahead.gap_m) {
      ahead.gap_m = gap_m;
      ahead.bearing_rad = std::atan2(nearest_m.y(), nearest_m.x());
    }
  }
  const Eigen::Vector2d direction = geometry::unit_vector(T_map_robot.heading_rad());
  ahead.ahead_m = first_hit(walls_, T_map_robot.position_m(), direction).range_m - radius_m;
  return ahead;
}

bool PolygonView::is_floor(const Eigen::Vector2d& point_m) const {
  return outline_.contains(point_m) &&
         std::none_of(holes_.begin(), holes_.end(), [&](const geometry::ReflexOutline& hole) {
           return hole.contains(point_m);
         });
}

mapping::RasterMap rasterize(const mapping::PolygonMap& map, double resolution_m) {
  geometry::ParameterValidator("polygon view").positive("resolution_m", resolution_m);
  Eigen::Vector2d low_m = map.outline_m().front();
  Eigen::Vector2d high_m = low_m;
  for (const Eigen::Vector2d& corner_m : map.outline_m()) {
    low_m = low_m.cwiseMin(corner_m);
    high_m = high_m.cwiseMax(corner_m);
  }
  const Eigen::Vector2d cells = (high_m - low_m) / resolution_m;
  mapping::RasterMap raster(static_cast<int>(std::ceil(cells.x())),
                            static_cast<int>(std::ceil(cells.y())),
                            resolution_m,
                            low_m);
  const PolygonView view(map);
  for (geometry::CellIndex cell{0, 0}; cell.y < raster.rows(); ++cell.y) {
    for (cell.x = 0; cell.x < raster.columns(); ++cell.x) {
      raster.set(cell,
                 view.is_floor(raster.center_m(cell)) ? mapping::CellState::kFree
                                                      : mapping::CellState::kOccupied);
    }
  }
  return raster;
}

}  // namespace echomap::localization
