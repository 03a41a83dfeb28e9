// SPDX-License-Identifier: MIT
#include "host/mapping/distance_field.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <tuple>

#include <gtest/gtest.h>

namespace echomap::mapping {
namespace {

constexpr double kNoLimit = std::numeric_limits<double>::infinity();

void scatter(int count, std::mt19937& random, RasterMap& map) {
  for (int i = 0; i < count; ++i) {
    map.set({static_cast<std::int32_t>(random() % static_cast<unsigned>(map.columns())),
             static_cast<std::int32_t>(random() % static_cast<unsigned>(map.rows()))},
            random() % 4 == 0 ? CellState::kFree : CellState::kOccupied);
  }
}

float nearest_cells(const RasterMap& map, geometry::CellIndex cell, float max_cells) {
  float nearest = max_cells;
  for (std::int32_t y = 0; y < map.rows(); ++y) {
    for (std::int32_t x = 0; x < map.columns(); ++x) {
      if (map.state({x, y}) == CellState::kOccupied) {
        const auto square =
            static_cast<float>((x - cell.x) * (x - cell.x) + (y - cell.y) * (y - cell.y));
        nearest = std::min(nearest, std::sqrt(square));
      }
    }
  }
  return nearest;
}

void expect_exact(const DistanceField& field, const RasterMap& map, double max_m) {
  const auto max_cells = static_cast<float>(max_m / map.resolution_m());
  for (std::int32_t y = 0; y < map.rows(); ++y) {
    for (std::int32_t x = 0; x < map.columns(); ++x) {
      ASSERT_EQ(field.distance_cells({x, y}), nearest_cells(map, {x, y}, max_cells))
          << x << ' ' << y;
    }
  }
}

TEST(DistanceField, IsThatOfALoopOverAllCells) {
  std::mt19937 random(31);
  for (const auto& [columns, rows, obstacles] :
       {std::tuple{1, 1, 1}, {37, 1, 3}, {1, 40, 2}, {70, 50, 1}, {70, 50, 30}, {300, 20, 9}}) {
    RasterMap map(columns, rows, 0.05, {0.0, 0.0});
    scatter(obstacles, random, map);
    map.set({0, 0}, CellState::kOccupied);
    expect_exact(DistanceField(map, kNoLimit), map, kNoLimit);
    expect_exact(DistanceField(map, 0.4), map, 0.4);
  }
}

TEST(DistanceField, IsExactOnEitherSideOfTheReachThatSixteenBitsHold) {
  std::mt19937 random(33);
  RasterMap map(420, 40, 0.05, {0.0, 0.0});
  scatter(4, random, map);
  map.set({0, 0}, CellState::kOccupied);
  for (const double max_m : {9.04, 9.05, 9.06}) {
    expect_exact(DistanceField(map, max_m), map, max_m);
  }
}

TEST(DistanceField, CountsTheGreatestDistanceWhereNothingStands) {
  const RasterMap map(100, 80, 0.05, {0.0, 0.0});
  const DistanceField field(map, 2.0);
  EXPECT_EQ(field.distance_cells({50, 50}), 40.0F);
}

TEST(DistanceField, IsRightAgainAfterAnyChangeOfATile) {
  std::mt19937 random(37);
  RasterMap map(260, 230, 0.05, {0.0, 0.0});
  scatter(150, random, map);
  DistanceField field(map, 1.0);
  for (int round = 0; round < 40; ++round) {
    const CellBounds tile{{static_cast<std::int32_t>(random() % 300) - 30,
                           static_cast<std::int32_t>(random() % 280) - 30},
                          {0, 0}};
    const CellBounds changed{tile.min, {tile.min.x + 63, tile.min.y + 63}};
    for (int i = 0; i < 40; ++i) {
      const geometry::CellIndex cell{changed.min.x + static_cast<std::int32_t>(random() % 64),
                                     changed.min.y + static_cast<std::int32_t>(random() % 64)};
      if (map.contains(cell)) {
        map.set(cell, random() % 2 == 0 ? CellState::kOccupied : CellState::kUnknown);
      }
    }
    field.update(map, changed);
    const DistanceField anew(map, 1.0);
    for (std::int32_t y = 0; y < map.rows(); ++y) {
      ASSERT_TRUE(std::equal(field.row(y), field.row(y) + map.columns(), anew.row(y)))
          << "round " << round << " row " << y;
    }
  }
}

TEST(DistanceField, TakesAChangeOutsideOfTheMapAsNone) {
  const RasterMap map(20, 20, 0.05, {0.0, 0.0});
  DistanceField field(map, 1.0);
  field.update(map, {{30, 30}, {93, 93}});
  field.update(map, {{-93, 5}, {-30, 9}});
  field.update(map, {});
  EXPECT_EQ(field.distance_cells({19, 19}), 20.0F);
}

TEST(DistanceField, RefusesWhatItCannotHold) {
  const RasterMap map(20, 20, 0.05, {0.0, 0.0});
  EXPECT_THROW(DistanceField(map, 0.0), std::invalid_argument);
  EXPECT_THROW(DistanceField(RasterMap(16385, 1, 0.05, {0.0, 0.0}), 1.0), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::mapping
