// SPDX-License-Identifier: MIT
#include "host/localization/point_cloud_view.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "host/geometry/unit_vector.hpp"
#include "host/mapping/vector_clones.hpp"

namespace echomap::localization {

namespace {

const PointCloudViewParams& checked(const PointCloudViewParams& params) {
  if (!(params.half_width_m > 0.0) || !(params.half_opening_rad > 0.0) ||
      !(params.max_range_m > 0.0)) {
    throw std::invalid_argument("point cloud view: widths and ranges are above 0");
  }
  return params;
}

constexpr std::size_t kLanes = 8;

struct Beam {
  float x_m, y_m, way_x, way_y;
  float half_width_m, slope;
};

/// How far along a beam the nearest point on it is; `most_m` without one. No branches.
ECHOMAP_VECTOR_CLONES
float nearest_along(const float* __restrict x_m,
                    const float* __restrict y_m,
                    std::size_t count,
                    const Beam beam,
                    float most_m) {
  std::array<float, kLanes> nearest_m;
  nearest_m.fill(most_m);
  for (std::size_t begin = 0; begin < count; begin += kLanes) {
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      const float off_x_m = x_m[begin + lane] - beam.x_m;
      const float off_y_m = y_m[begin + lane] - beam.y_m;
      const float along_m = beam.way_x * off_x_m + beam.way_y * off_y_m;
      const float aside_m = std::abs(beam.way_x * off_y_m - beam.way_y * off_x_m);
      const float within_m = std::max(beam.half_width_m, beam.slope * along_m);
      const float ahead_m = along_m > 0.0F ? along_m : most_m;
      const float on_beam_m = aside_m <= within_m ? ahead_m : most_m;
      nearest_m[lane] = on_beam_m < nearest_m[lane] ? on_beam_m : nearest_m[lane];
    }
  }
  return *std::min_element(nearest_m.begin(), nearest_m.end());
}

}  // namespace

PointCloudView::PointCloudView(const std::vector<Eigen::Vector2d>& points_m,
                               const PointCloudViewParams& params)
    : params_(checked(params)), slope_(std::tan(params.half_opening_rad)) {
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
  const Eigen::Vector2d way = geometry::unit_vector(T_map_sensor.heading_rad());
  const auto most_m = static_cast<float>(params_.max_range_m);
  const Beam beam{static_cast<float>(T_map_sensor.x_m()),
                  static_cast<float>(T_map_sensor.y_m()),
                  static_cast<float>(way.x()),
                  static_cast<float>(way.y()),
                  static_cast<float>(params_.half_width_m),
                  static_cast<float>(slope_)};
  const float nearest_m = nearest_along(x_m_.data(), y_m_.data(), x_m_.size(), beam, most_m);
  if (nearest_m >= most_m) {
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
