// SPDX-License-Identifier: MIT
#include "host/slam/surface_field.hpp"

#include <algorithm>
#include <cmath>

#include "host/geometry/parameter_validator.hpp"

namespace echomap::slam {
namespace {

/// Points that spread along their surface by less than so many times the noise do not tell how it
/// lies: they may be those of one beam that grazes a wall.
constexpr double kMinLength = 1.5;

}  // namespace

void SurfaceField::Moments::add(const Eigen::Vector2d& point_m) {
  count += 1.0;
  sum_m += point_m;
  square_xx_m2 += point_m.x() * point_m.x();
  square_xy_m2 += point_m.x() * point_m.y();
  square_yy_m2 += point_m.y() * point_m.y();
}

void SurfaceField::Moments::add(const Moments& other) {
  count += other.count;
  sum_m += other.sum_m;
  square_xx_m2 += other.square_xx_m2;
  square_xy_m2 += other.square_xy_m2;
  square_yy_m2 += other.square_yy_m2;
}

SurfaceField::Cell& SurfaceField::Level::cell(geometry::CellIndex at) {
  std::int32_t number = index.find(at);
  if (number == mapping::TileIndex::kNone) {
    number = static_cast<std::int32_t>(cells.size());
    index.insert(at, number);
    cells.emplace_back();
  }
  return cells[static_cast<std::size_t>(number)];
}

SurfaceField::SurfaceField(const SurfaceFieldParams& params) : params_(params) {
  geometry::ParameterValidator("surface field")
      .positive("cell_m", params.cell_m)
      .positive("noise_m", params.noise_m)
      .at_least("min_points", params.min_points, 3);
  double scale = 1.0;
  for (Level& level : levels_) {
    level.cell_m = scale * params.cell_m;
    level.cells_per_m = 1.0 / level.cell_m;
    level.noise_m = scale * params.noise_m;
    scale *= 2.0;
  }
}

void SurfaceField::clear() {
  ++revision_;
  for (Level& level : levels_) {
    level.index.clear();
    level.cells.clear();
  }
}

void SurfaceField::add(std::span<const Eigen::Vector2d> points_m) {
  ++revision_;
  for (int level = 0; level < kLevels; ++level) {
    Level& filled = levels_[static_cast<std::size_t>(level)];
    for (const Eigen::Vector2d& point_m : points_m) {
      filled.cell(cell_at(point_m, level)).moments.add(point_m);
    }
  }
}

Surface SurfaceField::surface_at(geometry::CellIndex cell, int level) {
  while (true) {
    Level& asked = levels_[static_cast<std::size_t>(level)];
    Cell& found = asked.cell(cell);
    if (found.fitted != revision_) {
      found.surface = fitted(asked, moments_around(asked, cell));
      found.fitted = revision_;
    }
    if (!found.surface.empty() || level + 1 == kLevels) {
      return found.surface;
    }
    // Cells double from level to level.
    cell = {cell.x >> 1, cell.y >> 1};
    ++level;
  }
}

SurfaceField::Moments SurfaceField::moments_around(const Level& level,
                                                   geometry::CellIndex middle) const {
  Moments around;
  for (std::int32_t y = middle.y - 1; y <= middle.y + 1; ++y) {
    for (std::int32_t x = middle.x - 1; x <= middle.x + 1; ++x) {
      const std::int32_t number = level.index.find({x, y});
      if (number != mapping::TileIndex::kNone) {
        around.add(level.cells[static_cast<std::size_t>(number)].moments);
      }
    }
  }
  return around;
}

Surface SurfaceField::fitted(const Level& level, const Moments& moments) const {
  if (moments.count < params_.min_points) {
    return {};
  }
  const Eigen::Vector2d mean_m = moments.sum_m / moments.count;
  const double xx_m2 = moments.square_xx_m2 / moments.count - mean_m.x() * mean_m.x();
  const double xy_m2 = moments.square_xy_m2 / moments.count - mean_m.x() * mean_m.y();
  const double yy_m2 = moments.square_yy_m2 / moments.count - mean_m.y() * mean_m.y();
  const double middle_m2 = (xx_m2 + yy_m2) / 2.0;
  const double reach_m2 = std::hypot((xx_m2 - yy_m2) / 2.0, xy_m2);
  const double noise_m2 = level.noise_m * level.noise_m;
  if (middle_m2 + reach_m2 < kMinLength * kMinLength * noise_m2) {
    return {};
  }
  const double across = 1.0 / (std::max(0.0, middle_m2 - reach_m2) + noise_m2);
  // The direction along: twice its angle is that of ((xx - yy) / 2, xy).
  const double cos_twice = reach_m2 > 0.0 ? (xx_m2 - yy_m2) / 2.0 / reach_m2 : 1.0;
  const double sin_twice = reach_m2 > 0.0 ? xy_m2 / reach_m2 : 0.0;
  return {mean_m,
          across / 2.0 * (1.0 - cos_twice),
          -across / 2.0 * sin_twice,
          across / 2.0 * (1.0 + cos_twice)};
}

}  // namespace echomap::slam
