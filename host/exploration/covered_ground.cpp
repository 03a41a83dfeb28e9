// SPDX-License-Identifier: MIT
#include "host/exploration/covered_ground.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace echomap::exploration {

using geometry::CellIndex;

CoveredGround::CoveredGround(double reach_m, double cell_m) : reach_m_(reach_m), cell_m_(cell_m) {
  if (!(reach_m > 0.0) || !(cell_m > 0.0)) {
    throw std::invalid_argument("covered ground: reach and cell are above 0");
  }
}

void CoveredGround::cover(const Eigen::Vector2d& place_m) { add_disc(place_m, reach_m_, covered_); }

void CoveredGround::add_disc(const Eigen::Vector2d& place_m,
                             double radius_m,
                             std::set<CellIndex>& cells) const {
  const CellIndex low = cell_at(place_m.array() - radius_m);
  const CellIndex high = cell_at(place_m.array() + radius_m);
  for (CellIndex cell = low; cell.y <= high.y; ++cell.y) {
    for (cell.x = low.x; cell.x <= high.x; ++cell.x) {
      if ((center_m(cell) - place_m).norm() <= radius_m) {
        cells.insert(cell);
      }
    }
  }
}

bool CoveredGround::is_covered(const Eigen::Vector2d& place_m) const {
  return covered_.contains(cell_at(place_m));
}

void CoveredGround::give_up(const Eigen::Vector2d& place_m) {
  add_disc(place_m, 0.5 * reach_m_, given_up_);
}

bool CoveredGround::knows_the_room() const {
  return std::any_of(
      loops_.begin(), loops_.end(), [](const WallLoop& loop) { return !loop.is_island; });
}

std::optional<Eigen::Vector2d> CoveredGround::nearest_left_m(const Eigen::Vector2d& place_m) const {
  std::optional<Eigen::Vector2d> nearest;
  double nearest_m = std::numeric_limits<double>::infinity();
  for (const CellIndex& cell : covered_) {
    for (const CellIndex next : {CellIndex{cell.x + 1, cell.y},
                                 CellIndex{cell.x - 1, cell.y},
                                 CellIndex{cell.x, cell.y + 1},
                                 CellIndex{cell.x, cell.y - 1}}) {
      const Eigen::Vector2d left_m = center_m(next);
      const double away_m = (left_m - place_m).norm();
      if (away_m < nearest_m && !covered_.contains(next) && !given_up_.contains(next) &&
          may_be_floor(left_m)) {
        nearest = left_m;
        nearest_m = away_m;
      }
    }
  }
  return nearest;
}

CellIndex CoveredGround::cell_at(const Eigen::Vector2d& place_m) const {
  return {static_cast<std::int32_t>(std::floor(place_m.x() / cell_m_)),
          static_cast<std::int32_t>(std::floor(place_m.y() / cell_m_))};
}

Eigen::Vector2d CoveredGround::center_m(CellIndex cell) const {
  return cell_m_ * Eigen::Vector2d(cell.x + 0.5, cell.y + 0.5);
}

bool CoveredGround::may_be_floor(const Eigen::Vector2d& place_m) const {
  return std::all_of(loops_.begin(), loops_.end(), [&](const WallLoop& loop) {
    return geometry::contains(loop.path_m, place_m) != loop.is_island;
  });
}

}  // namespace echomap::exploration
