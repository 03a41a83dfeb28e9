// SPDX-License-Identifier: MIT
#include "host/slam/loop_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "host/geometry/parameter_validator.hpp"
#include "host/geometry/unit_vector.hpp"

namespace echomap::slam {
namespace {

constexpr double kFullCount = 255.0;

std::vector<Eigen::Vector2d> thinned(std::span<const Eigen::Vector2d> points_m, std::size_t most) {
  const std::size_t step = (points_m.size() + most - 1) / most;
  std::vector<Eigen::Vector2d> kept_m;
  for (std::size_t i = 0; i < points_m.size(); i += step) {
    kept_m.push_back(points_m[i]);
  }
  return kept_m;
}

}  // namespace

LoopSearch::LoopSearch(const LoopSearchParams& params) : params_(params) {
  geometry::ParameterValidator("loop search")
      .positive("cell_m", params.cell_m)
      .positive("spread_m", params.spread_m)
      .at_least("levels", params.levels, 1)
      .at_most("levels", params.levels, 10)
      .positive("reach_m", params.reach_m)
      .at_least("max_points", params.max_points, 1);
}

std::optional<FoundPlace> LoopSearch::find(std::span<const Eigen::Vector2d> map_points_m,
                                           std::span<const Eigen::Vector2d> points_m,
                                           const SearchWindow& window) {
  if (map_points_m.empty() || points_m.empty()) {
    return std::nullopt;
  }
  draw(map_points_m);
  const std::vector<Eigen::Vector2d> compared_m = thinned(points_m, params_.max_points);
  const int radius = static_cast<int>(std::ceil(window.radius_m / params_.cell_m));
  const double step_rad = params_.cell_m / params_.reach_m;
  const int turns = static_cast<int>(std::ceil(window.turn_rad / step_rad));
  const int top = params_.levels - 1;
  const int edge = 1 << top;
  Branch best{0, 0, 0, params_.min_score};
  std::optional<FoundPlace> found;
  for (int turn = -turns; turn <= turns; ++turn) {
    const double heading_rad = window.T_map_robot.heading_rad() + turn * step_rad;
    const auto cells = cells_of(compared_m, window.T_map_robot.position_m(), heading_rad);
    const double before = best.score;
    for (int y = -radius; y <= radius; y += edge) {
      for (int x = -radius; x <= radius; x += edge) {
        Branch branch{x, y, top, 0.0};
        branch.score = score(cells, branch);
        search(cells, radius, branch, best);
      }
    }
    if (best.score > before) {
      const Eigen::Vector2d position_m =
          window.T_map_robot.position_m() + params_.cell_m * Eigen::Vector2d(best.x, best.y);
      found = {{position_m.x(), position_m.y(), heading_rad}, best.score};
    }
  }
  return found;
}

void LoopSearch::search(const std::vector<Cell>& cells,
                        int radius,
                        const Branch& branch,
                        Branch& best) const {
  if (branch.x > radius || branch.y > radius || branch.score <= best.score) {
    return;
  }
  if (branch.level == 0) {
    best = branch;
    return;
  }
  const int half = 1 << (branch.level - 1);
  std::array<Branch, 4> parts{{{branch.x, branch.y, branch.level - 1, 0.0},
                               {branch.x + half, branch.y, branch.level - 1, 0.0},
                               {branch.x, branch.y + half, branch.level - 1, 0.0},
                               {branch.x + half, branch.y + half, branch.level - 1, 0.0}}};
  for (Branch& part : parts) {
    part.score = score(cells, part);
  }
  std::sort(parts.begin(), parts.end(), [](const Branch& one, const Branch& other) {
    return one.score > other.score;
  });
  for (const Branch& part : parts) {
    search(cells, radius, part, best);
  }
}

double LoopSearch::score(const std::vector<Cell>& cells, const Branch& branch) const {
  int sum = 0;
  for (const Cell& cell : cells) {
    sum += at(branch.level, cell.x + branch.x, cell.y + branch.y);
  }
  return sum / (kFullCount * static_cast<double>(cells.size()));
}

std::uint8_t LoopSearch::at(int level, int x, int y) const {
  if (x < 0 || y < 0 || x >= columns_ || y >= rows_) {
    return 0;
  }
  return max_[static_cast<std::size_t>(level)]
             [static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) +
              static_cast<std::size_t>(x)];
}

std::vector<LoopSearch::Cell> LoopSearch::cells_of(std::span<const Eigen::Vector2d> points_m,
                                                   const Eigen::Vector2d& position_m,
                                                   double heading_rad) const {
  const Eigen::Vector2d ahead = geometry::unit_vector(heading_rad);
  std::vector<Cell> cells;
  cells.reserve(points_m.size());
  for (const Eigen::Vector2d& point_m : points_m) {
    const Eigen::Vector2d placed_m =
        position_m + point_m.x() * ahead + point_m.y() * geometry::perpendicular(ahead);
    const Eigen::Vector2d in_cells = (placed_m - origin_m_) / params_.cell_m;
    cells.push_back(
        {static_cast<int>(std::floor(in_cells.x())), static_cast<int>(std::floor(in_cells.y()))});
  }
  return cells;
}

void LoopSearch::draw(std::span<const Eigen::Vector2d> map_points_m) {
  Eigen::Vector2d low_m = map_points_m.front();
  Eigen::Vector2d high_m = low_m;
  for (const Eigen::Vector2d& point_m : map_points_m) {
    low_m = low_m.cwiseMin(point_m);
    high_m = high_m.cwiseMax(point_m);
  }
  // The maxima of squares reach to the left of and below what they are of.
  const double spread_m = (reach_cells() + 1) * params_.cell_m;
  const double squares_m = (1 << (params_.levels - 1)) * params_.cell_m;
  origin_m_ = low_m.array() - (squares_m + spread_m);
  const Eigen::Vector2d size_m = (high_m - origin_m_).array() + spread_m;
  columns_ = static_cast<int>(size_m.x() / params_.cell_m) + 1;
  rows_ = static_cast<int>(size_m.y() / params_.cell_m) + 1;
  max_.assign(static_cast<std::size_t>(params_.levels),
              std::vector<std::uint8_t>(static_cast<std::size_t>(columns_ * rows_)));
  const std::vector<std::uint8_t> drawn = drawn_point();
  for (const Eigen::Vector2d& point_m : map_points_m) {
    draw_point(point_m, drawn);
  }
  for (int level = 1; level < params_.levels; ++level) {
    add_level(level);
  }
}

std::vector<std::uint8_t> LoopSearch::drawn_point() const {
  const int reach = reach_cells();
  std::vector<std::uint8_t> drawn;
  for (int y = -reach; y <= reach; ++y) {
    for (int x = -reach; x <= reach; ++x) {
      const double away_m = params_.cell_m * std::hypot(x, y);
      const double sigmas = away_m / params_.spread_m;
      drawn.push_back(static_cast<std::uint8_t>(kFullCount * std::exp(-0.5 * sigmas * sigmas)));
    }
  }
  return drawn;
}

int LoopSearch::reach_cells() const {
  return static_cast<int>(std::ceil(2.0 * params_.spread_m / params_.cell_m));
}

void LoopSearch::draw_point(const Eigen::Vector2d& point_m,
                            const std::vector<std::uint8_t>& drawn) {
  const int x0 = static_cast<int>((point_m.x() - origin_m_.x()) / params_.cell_m);
  const int y0 = static_cast<int>((point_m.y() - origin_m_.y()) / params_.cell_m);
  const int reach = reach_cells();
  auto value = drawn.begin();
  for (int y = y0 - reach; y <= y0 + reach; ++y) {
    std::uint8_t* cell = &max_[0][static_cast<std::size_t>(y * columns_ + x0 - reach)];
    for (int x = 0; x <= 2 * reach; ++x, ++cell, ++value) {
      *cell = std::max(*cell, *value);
    }
  }
}

void LoopSearch::add_level(int level) {
  const auto& finer = max_[static_cast<std::size_t>(level - 1)];
  auto& coarser = max_[static_cast<std::size_t>(level)];
  const auto columns = static_cast<std::size_t>(columns_);
  const int half = 1 << (level - 1);
  for (int y = 0; y < rows_; ++y) {
    const int above = std::min(y + half, rows_ - 1);
    const std::uint8_t* low = &finer[static_cast<std::size_t>(y) * columns];
    const std::uint8_t* high = &finer[static_cast<std::size_t>(above) * columns];
    std::uint8_t* target = &coarser[static_cast<std::size_t>(y) * columns];
    for (int x = 0; x < columns_; ++x) {
      const int right = std::min(x + half, columns_ - 1);
      target[x] = std::max(std::max(low[x], low[right]), std::max(high[x], high[right]));
    }
  }
}

}  // namespace echomap::slam
