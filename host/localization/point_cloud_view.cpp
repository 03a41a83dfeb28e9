// SPDX-License-Identifier: MIT
#include "host/localization/point_cloud_view.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "host/geometry/parameter_validator.hpp"
#include "host/geometry/unit_vector.hpp"
#include "host/mapping/vector_clones.hpp"

namespace echomap::localization {

namespace {

const PointCloudViewParams& validated(const PointCloudViewParams& params) {
  geometry::ParameterValidator("point cloud view")
      .positive("half_width_m", params.half_width_m)
      .positive("beam_half_angle_rad", params.beam_half_angle_rad)
      .positive("max_range_m", params.max_range_m);
  return params;
}

constexpr std::size_t kLanes = 8;

struct Beam {
  float x_m, y_m, way_x, way_y;
  float half_width_m, slope;
};

/// How far along a beam the nearest point on it is; `max_m` without one. No branches.
ECHOMAP_VECTOR_CLONES
float nearest_along(const float* __restrict x_m,
                    const float* __restrict y_m,
                    std::size_t count,
                    const Beam beam,
                    float max_m) {
  std::array<float, kLanes> nearest_m;
  nearest_m.fill(max_m);
  for (std::size_t begin = 0; begin < count; begin += kLanes) {
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      const float off_x_m = x_m[begin + lane] - beam.x_m;
      const float off_y_m = y_m[begin + lane] - beam.y_m;
      const float along_m = beam.way_x * off_x_m + beam.way_y * off_y_m;
      const float aside_m = std::abs(beam.way_x * off_y_m - beam.way_y * off_x_m);
      const float within_m = std::max(beam.half_width_m, beam.slope * along_m);
      const float ahead_m = along_m > 0.0F ? along_m : max_m;
      const float on_beam_m = aside_m <= within_m ? ahead_m : max_m;
      nearest_m[lane] = on_beam_m < nearest_m[lane] ? on_beam_m : nearest_m[lane];
    }
  }
  return *std::min_element(nearest_m.begin(), nearest_m.end());
}

}  // namespace

PointCloudView::PointCloudView(const std::vector<Eigen::Vector2d>& points_m,
                               const PointCloudViewParams& params)
    : params_(validated(params)), slope_(std::tan(params.beam_half_angle_rad)) {
  constexpr float kFarM = 1e6F;
  const std::size_t whole = (points_m.size() + kLanes - 1) / kLanes * kLanes;
  x_m_.assign(whole, kFarM);
  y_m_.assign(whole, kFarM);
  for (std::size_t i = 0; i < points_m.size(); ++i) {
    x_m_[i] = static_cast<float>(points_m[i].x());
    y_m_[i] = static_cast<float>(points_m[i].y());
  }
}

models::ExpectedRange PointCloudView::expected(const geometry::Pose2& T_map_sensor) const {
  const Eigen::Vector2d direction = geometry::unit_vector(T_map_sensor.heading_rad());
  const auto max_m = static_cast<float>(params_.max_range_m);
  const Beam beam{static_cast<float>(T_map_sensor.x_m()),
                  static_cast<float>(T_map_sensor.y_m()),
                  static_cast<float>(direction.x()),
                  static_cast<float>(direction.y()),
                  static_cast<float>(params_.half_width_m),
                  static_cast<float>(slope_)};
  const float nearest_m = nearest_along(x_m_.data(), y_m_.data(), x_m_.size(), beam, max_m);
  if (nearest_m >= max_m) {
    return {};
  }
  return {static_cast<double>(nearest_m), false};
}

std::vector<Eigen::Vector2d> occupied_points(const mapping::RasterMap& map) {
  std::vector<Eigen::Vector2d> points_m;
  for (geometry::CellIndex cell{0, 0}; cell.y < map.rows(); ++cell.y) {
    for (cell.x = 0; cell.x < map.columns(); ++cell.x) {
      if (map.state(cell) == mapping::CellState::kOccupied) {
        points_m.push_back(map.center_m(cell));
      }
    }
  }
  return points_m;
}

}  // namespace echomap::localization
