// SPDX-License-Identifier: MIT
#include "tests/benchmarks/room_symmetry.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <Eigen/Geometry>

#include "host/geometry/angle.hpp"

namespace echomap::bench {
namespace {

constexpr double kRasterM = 0.05;
constexpr double kSameFloorIou = 0.97;

/// The middles of the cells of a square about `centre_m`.
std::vector<Eigen::Vector2d> cells_about(const Eigen::Vector2d& centre_m, double reach_m) {
  const int reach = static_cast<int>(std::ceil(reach_m / kRasterM));
  std::vector<Eigen::Vector2d> cells_m;
  for (int row = -reach; row < reach; ++row) {
    for (int column = -reach; column < reach; ++column) {
      cells_m.emplace_back(centre_m + kRasterM * Eigen::Vector2d(column + 0.5, row + 0.5));
    }
  }
  return cells_m;
}

Eigen::Vector2d centroid_m(const world::FloorPlan& plan) {
  Eigen::AlignedBox2d room;
  for (const Eigen::Vector2d& corner_m : plan.room_m()) {
    room.extend(corner_m);
  }
  Eigen::Vector2d sum_m = Eigen::Vector2d::Zero();
  std::size_t free = 0;
  for (const auto& cell_m : cells_about(room.center(), 0.5 * room.sizes().maxCoeff())) {
    if (plan.is_free(cell_m)) {
      sum_m += cell_m;
      ++free;
    }
  }
  return sum_m / static_cast<double>(free);
}

}  // namespace

double turned_floor_iou(const world::FloorPlan& plan, double turn_rad) {
  const Eigen::Vector2d centre_m = centroid_m(plan);
  double reach_m = 0.0;
  for (const Eigen::Vector2d& corner_m : plan.room_m()) {
    reach_m = std::max(reach_m, (corner_m - centre_m).norm());
  }
  const Eigen::Rotation2Dd back(-turn_rad);
  std::size_t both = 0;
  std::size_t either = 0;
  for (const auto& cell_m : cells_about(centre_m, reach_m)) {
    const bool is_free = plan.is_free(cell_m);
    const bool is_turned_free = plan.is_free(centre_m + back * (cell_m - centre_m));
    both += is_free && is_turned_free ? 1 : 0;
    either += is_free || is_turned_free ? 1 : 0;
  }
  return static_cast<double>(both) / static_cast<double>(either);
}

std::optional<double> symmetry_turn_rad(const world::FloorPlan& plan) {
  for (const double turn_deg : {45.0, 60.0, 90.0, 120.0, 180.0}) {
    const double turn_rad = geometry::radians(turn_deg);
    if (turned_floor_iou(plan, turn_rad) >= kSameFloorIou) {
      return turn_rad;
    }
  }
  return std::nullopt;
}

}  // namespace echomap::bench
