// SPDX-License-Identifier: MIT
#include "host/mapping/cylinder_detection.hpp"

#include <cmath>
#include <numbers>
#include <optional>

#include "host/geometry/parameter_validator.hpp"

namespace echomap::mapping {

namespace {

using Run = std::span<const Eigen::Vector2d>;

void validate(const CylinderDetectionParams& params) {
  geometry::ParameterValidator("cylinder detection")
      .positive("radius_m", params.radius_m)
      .positive("max_gap_m", params.max_gap_m)
      .positive("min_step_m", params.min_step_m)
      .at_least("width_tolerance_m", params.width_tolerance_m, 0.0)
      .at_least("min_points", params.min_points, 1);
}

/// Whether a neighbour of the run's end lies well behind it.
bool is_behind(const Eigen::Vector2d& neighbour_m,
               const Eigen::Vector2d& end_m,
               const CylinderDetectionParams& params) {
  return neighbour_m.norm() - end_m.norm() > params.min_step_m;
}

std::optional<Eigen::Vector2d> cylinder_of(Run run, const CylinderDetectionParams& params) {
  const double width_m = (run.back() - run.front()).norm();
  if (run.size() < params.min_points ||
      std::abs(width_m - 2.0 * params.radius_m) > params.width_tolerance_m) {
    return std::nullopt;
  }
  Eigen::Vector2d along = Eigen::Vector2d::Zero();
  double range_m = 0.0;
  for (const Eigen::Vector2d& point_m : run) {
    along += point_m.normalized();
    range_m += point_m.norm() / static_cast<double>(run.size());
  }
  return (range_m + 0.25 * std::numbers::pi * params.radius_m) * along.normalized();
}

}  // namespace

std::vector<Eigen::Vector2d> find_cylinders(std::span<const Eigen::Vector2d> points_m,
                                            const CylinderDetectionParams& params) {
  validate(params);
  std::vector<Eigen::Vector2d> centers_m;
  std::size_t begin = 0;
  for (std::size_t i = 1; i < points_m.size(); ++i) {
    if ((points_m[i] - points_m[i - 1]).norm() <= params.max_gap_m) {
      continue;
    }
    const Run run = points_m.subspan(begin, i - begin);
    const bool stands_alone = begin > 0 && is_behind(points_m[begin - 1], run.front(), params) &&
                              is_behind(points_m[i], run.back(), params);
    begin = i;
    if (!stands_alone) {
      continue;
    }
    if (const auto center_m = cylinder_of(run, params)) {
      centers_m.push_back(*center_m);
    }
  }
  return centers_m;
}

}  // namespace echomap::mapping
