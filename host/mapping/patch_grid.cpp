// SPDX-License-Identifier: MIT
#include "host/mapping/patch_grid.hpp"

#include <algorithm>
#include <cmath>

#include "host/geometry/parameter_validator.hpp"

namespace echomap::mapping {

namespace {

using geometry::CellIndex;

/// Calls `visit` with the index of each cell that the field has within `reach_m`, in x and in y.
template <typename Visit>
void for_cells_around(const CellField& field,
                      const Eigen::Vector2d& middle_m,
                      double reach_m,
                      const Visit& visit) {
  const CellIndex low = field.cell_at(middle_m.array() - reach_m);
  const CellIndex high = field.cell_at(middle_m.array() + reach_m);
  const CellBounds& bounds = field.bounds();
  for (int y = std::max(low.y, bounds.min.y); y <= std::min(high.y, bounds.max.y); ++y) {
    for (int x = std::max(low.x, bounds.min.x); x <= std::min(high.x, bounds.max.x); ++x) {
      visit(field.index({x, y}));
    }
  }
}

const PatchGridParams& validated(const PatchGridParams& params) {
  geometry::ParameterValidator("patch grid")
      .require(!params.cells.empty() && params.cells.rows() >= 1, "cells hold at least one cell")
      .positive("cell_m", params.cell_m);
  return params;
}

}  // namespace

PatchGrid::PatchGrid(const PatchGridParams& params)
    : params_(validated(params)),
      patch_(params.patch),
      confidence_(params.cells, params.cell_m),
      lasting_(params.cells, params.cell_m) {}

void PatchGrid::mark_wall(const geometry::Segment& wall_m) {
  const double reach_m = 0.5 * (wall_m.length_m() + params_.cell_m);
  for_cells_around(
      confidence_, 0.5 * (wall_m.from_m + wall_m.to_m), reach_m, [&](std::size_t index) {
        const Eigen::Vector2d center_m = confidence_.center_m(confidence_.cell(index));
        if (geometry::distance_m(wall_m, center_m) <= 0.5 * params_.cell_m) {
          lasting_[index] = std::max(lasting_[index], 1.0F);
          confidence_[index] = std::max(confidence_[index], lasting_[index]);
        }
      });
}

void PatchGrid::add_echo(const geometry::Pose2& T_grid_sonar, double range_m) {
  add_patch(T_grid_sonar * Eigen::Vector2d(range_m, 0.0), confidence_);
}

void PatchGrid::add_bump(const geometry::Segment& line_m) {
  const int steps = std::max(1, static_cast<int>(std::lround(line_m.length_m() / params_.cell_m)));
  for (int i = 0; i <= steps; ++i) {
    const double share = static_cast<double>(i) / steps;
    const Eigen::Vector2d point_m = line_m.from_m + share * (line_m.to_m - line_m.from_m);
    add_patch(point_m, confidence_);
    add_patch(point_m, lasting_);
  }
}

void PatchGrid::clear_cone(const geometry::Pose2& T_grid_sonar,
                           double range_m,
                           double beam_half_angle_rad) {
  const geometry::Pose2 T_sonar_grid = T_grid_sonar.inverse();
  for_cells_around(confidence_, T_grid_sonar.position_m(), range_m, [&](std::size_t index) {
    const auto at =
        models::polar_point(T_sonar_grid * confidence_.center_m(confidence_.cell(index)));
    if (at.range_m < range_m && std::abs(at.off_axis_rad) <= beam_half_angle_rad) {
      confidence_[index] = lasting_[index];
    }
  });
}

double PatchGrid::sum_ahead(const geometry::Pose2& T_grid_path,
                            double from_m,
                            double to_m,
                            double width_m) const {
  const geometry::Pose2 T_path_grid = T_grid_path.inverse();
  const double reach_m = std::max(std::abs(from_m), std::abs(to_m)) + width_m;
  double sum = 0.0;
  for_cells_around(confidence_, T_grid_path.position_m(), reach_m, [&](std::size_t index) {
    const Eigen::Vector2d at_m = T_path_grid * confidence_.center_m(confidence_.cell(index));
    const bool is_inside =
        at_m.x() >= from_m && at_m.x() <= to_m && std::abs(at_m.y()) <= 0.5 * width_m;
    sum += is_inside ? confidence_[index] : 0.0;
  });
  return sum;
}

void PatchGrid::add_patch(const Eigen::Vector2d& middle_m, CellField& field) const {
  for_cells_around(field, middle_m, patch_.reach_m({0.0}), [&](std::size_t index) {
    const double away_m = (field.center_m(field.cell(index)) - middle_m).norm();
    field[index] += static_cast<float>(patch_.evidence({0.0}, {away_m, 0.0}));
  });
}

}  // namespace echomap::mapping
