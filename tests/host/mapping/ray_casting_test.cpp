// SPDX-License-Identifier: MIT
#include "host/mapping/ray_casting.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "host/geometry/unit_vector.hpp"

namespace echomap::mapping {
namespace {

constexpr double kMaxM = 6.0;
constexpr double kSlackCells = 2e-3;

/// Cell by cell (Amanatides and Woo 1987): the range in cells at which the ray enters an occupied
/// cell that it runs through for at least `chord_cells`.
double walked_cells(const RasterMap& map,
                    const Eigen::Vector2d& from_cells,
                    const Eigen::Vector2d& direction,
                    double chord_cells) {
  geometry::CellIndex cell{static_cast<std::int32_t>(std::floor(from_cells.x())),
                           static_cast<std::int32_t>(std::floor(from_cells.y()))};
  const double max_cells = kMaxM / map.resolution_m();
  double at = 0.0;
  while (at < max_cells && map.contains(cell)) {
    const double to_x = (cell.x + (direction.x() > 0.0 ? 1 : 0) - from_cells.x()) / direction.x();
    const double to_y = (cell.y + (direction.y() > 0.0 ? 1 : 0) - from_cells.y()) / direction.y();
    const double leaves = std::min(to_x, to_y);
    if (map.state(cell) == CellState::kOccupied && leaves - at >= chord_cells) {
      return at;
    }
    (to_x < to_y ? cell.x : cell.y) += (to_x < to_y ? direction.x() : direction.y()) > 0.0 ? 1 : -1;
    at = leaves;
  }
  return max_cells;
}

RasterMap room(std::mt19937& random) {
  RasterMap map(160, 140, 0.05, {-1.0, -2.0});
  for (int i = 0; i < 60; ++i) {
    const geometry::CellIndex corner{static_cast<std::int32_t>(random() % 156),
                                     static_cast<std::int32_t>(random() % 136)};
    for (std::int32_t k = 0; k < 4; ++k) {
      map.set({corner.x + k, corner.y + (i % 2 == 0 ? 0 : k)}, CellState::kOccupied);
    }
  }
  return map;
}

TEST(RayCasting, FindsTheRangesOfAWalkFromCellToCell) {
  std::mt19937 random(41);
  const RasterMap map = room(random);
  const DistanceField field(map, 2.0);
  for (int place = 0; place < 60; ++place) {
    const Eigen::Vector2d from_cells(1.0 + static_cast<double>(random() % 15'700) / 100.0,
                                     1.0 + static_cast<double>(random() % 13'700) / 100.0);
    std::vector<Eigen::Vector2f> directions;
    for (int i = 0; i < 101; ++i) {
      directions.push_back(geometry::unit_vector(0.0623 * i + 0.001).cast<float>());
    }
    std::vector<float> ranges_m(directions.size());
    cast_rays(field, map.origin_m() + 0.05 * from_cells, directions, kMaxM, ranges_m);
    for (std::size_t i = 0; i < directions.size(); ++i) {
      const Eigen::Vector2d direction = directions[i].cast<double>();
      const double range_cells = ranges_m[i] / 0.05;
      EXPECT_GE(range_cells, walked_cells(map, from_cells, direction, 0.0) - kSlackCells)
          << place << ' ' << i;
      EXPECT_LE(range_cells,
                walked_cells(map, from_cells, direction, 2.0 * kSlackCells) + kSlackCells)
          << place << ' ' << i;
    }
  }
}

TEST(RayCasting, RunsAlongTheAxes) {
  RasterMap map(40, 40, 0.1, {0.0, 0.0});
  map.set({30, 20}, CellState::kOccupied);
  map.set({20, 5}, CellState::kOccupied);
  const DistanceField field(map, 10.0);
  const std::vector<Eigen::Vector2f> axes{{1.0F, 0.0F}, {-1.0F, 0.0F}, {0.0F, -1.0F}, {0.0F, 1.0F}};
  std::vector<float> ranges_m(4);
  cast_rays(field, {2.05, 2.05}, axes, 9.0, ranges_m);
  EXPECT_NEAR(ranges_m[0], 0.95F, 1e-4);
  EXPECT_EQ(ranges_m[1], 9.0F);
  EXPECT_NEAR(ranges_m[2], 1.45F, 1e-4);
  EXPECT_EQ(ranges_m[3], 9.0F);
}

TEST(RayCasting, EndsAtOnceInAnObstacleAndFindsNothingFromOutside) {
  RasterMap map(10, 10, 0.1, {0.0, 0.0});
  map.set({3, 3}, CellState::kOccupied);
  const DistanceField field(map, 10.0);
  const std::vector<Eigen::Vector2f> ahead{{1.0F, 0.0F}};
  std::vector<float> range_m(1);
  cast_rays(field, {0.35, 0.35}, ahead, 5.0, range_m);
  EXPECT_EQ(range_m[0], 0.0F);
  cast_rays(field, {-0.5, 0.35}, ahead, 5.0, range_m);
  EXPECT_EQ(range_m[0], 5.0F);
}

}  // namespace
}  // namespace echomap::mapping
