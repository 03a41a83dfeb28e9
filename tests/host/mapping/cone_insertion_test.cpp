// SPDX-License-Identifier: MIT
#include "host/mapping/cone_insertion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/geometry/unit_vector.hpp"

namespace echomap::mapping {
namespace {

using geometry::CellIndex;
using geometry::Pose2;

/// Past the border along a ray, in the sense of its column: above 0 to the right, below 0 to the
/// left, as seen with x to the right and y upwards.
std::int64_t past_border(double ray_rad, CellIndex from_apex) {
  const double columns = std::clamp(std::cos(ray_rad) / std::sin(ray_rad), -2001.0, 2001.0);
  return std::int64_t{512} * from_apex.x - std::int64_t{std::lround(512.0 * columns)} * from_apex.y;
}

bool is_within(double axis_rad, double half_rad, CellIndex from_apex) {
  const double left_rad = axis_rad + half_rad;
  const double right_rad = axis_rad - half_rad;
  const std::int64_t past_left = past_border(left_rad, from_apex);
  const std::int64_t past_right = past_border(right_rad, from_apex);
  return (std::sin(left_rad) >= 0.0 ? past_left >= 0 : past_left <= 0) &&
         (std::sin(right_rad) >= 0.0 ? past_right <= 0 : past_right >= 0);
}

/// What the header says, cell by cell: the evidence of one reading for one cell.
int told_centilogits(const ConeInsertionParams& params,
                     const ConeReading& reading,
                     const OccupancyGrid& grid,
                     CellIndex cell) {
  const Pose2& T_map_sonar = reading.T_map_sonar;
  const CellIndex apex = grid.cell_at(T_map_sonar.position_m());
  const Eigen::Vector2d apex_m = grid.center_m(apex);
  const Eigen::Vector2d way_m = grid.center_m(cell) - apex_m;
  const double axis_rad = T_map_sonar.heading_rad();
  const double ahead_m = geometry::unit_vector(axis_rad).dot(T_map_sonar.position_m() - apex_m);
  const double range_m = way_m.norm() - ahead_m;
  const auto part = [&](const std::vector<int>& parts) {
    const auto count = static_cast<double>(parts.size());
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const double half_rad = params.half_opening_rad * static_cast<double>(i + 1) / count;
      if (is_within(axis_rad, half_rad, {cell.x - apex.x, cell.y - apex.y})) {
        return parts[i];
      }
    }
    return 0;
  };
  if (way_m.norm() > params.reach_m) {
    return 0;
  }
  const double nearest_m = reading.arc_range_m.value_or(1e9) - params.half_thickness_m;
  if (range_m < nearest_m) {
    return range_m <= reading.free_range_m ? part(params.free_centilogits) : 0;
  }
  return range_m <= nearest_m + 2.0 * params.half_thickness_m ? part(params.arc_centilogits) : 0;
}

void insert_cell_by_cell(const ConeInsertionParams& params,
                         const ConeReading& reading,
                         OccupancyGrid& grid) {
  const CellIndex apex = grid.cell_at(reading.T_map_sonar.position_m());
  const auto reach = static_cast<std::int32_t>(params.reach_m / grid.resolution_m()) + 2;
  for (std::int32_t y = apex.y - reach; y <= apex.y + reach; ++y) {
    for (std::int32_t x = apex.x - reach; x <= apex.x + reach; ++x) {
      grid.add({x, y}, told_centilogits(params, reading, grid, {x, y}));
    }
  }
}

void expect_same(const OccupancyGrid& grid, const OccupancyGrid& expected) {
  ASSERT_EQ(grid.bounds().min, expected.bounds().min);
  ASSERT_EQ(grid.bounds().max, expected.bounds().max);
  const CellBounds& bounds = expected.bounds();
  for (std::int32_t y = bounds.min.y - 1; y <= bounds.max.y + 1; ++y) {
    for (std::int32_t x = bounds.min.x - 1; x <= bounds.max.x + 1; ++x) {
      ASSERT_EQ(grid.centilogits({x, y}), expected.centilogits({x, y})) << x << ' ' << y;
    }
  }
}

/// A raw generator number in [low, high).
double between(double low, double high, std::mt19937& random) {
  return low + (high - low) * (static_cast<double>(random()) / 4294967296.0);
}

ConeReading any_reading(std::mt19937& random) {
  ConeReading reading{Pose2(between(-3.0, 3.0, random),
                            between(-3.0, 3.0, random),
                            between(-std::numbers::pi, std::numbers::pi, random)),
                      between(-0.2, 6.0, random),
                      std::nullopt};
  if (random() % 3 != 0) {
    reading.arc_range_m = reading.free_range_m + between(-0.2, 0.4, random);
  }
  return reading;
}

TEST(ConeInsertion, MakesTheSameBytesAsALoopOverTheCells) {
  std::mt19937 random(11);
  for (const double half_opening_rad : {0.13, 0.286, 0.7, 1.5}) {
    ConeInsertionParams params;
    params.half_opening_rad = half_opening_rad;
    params.free_centilogits = {-40, -40, -35, -20, -15, -10, -5};
    params.arc_centilogits = {60, 50, 30, 0};
    params.reach_m = 4.987;
    params.half_thickness_m = between(0.0, 0.12, random);
    OccupancyGrid grid;
    OccupancyGrid expected;
    ConeInserter inserter(params, grid);
    for (int i = 0; i < 60; ++i) {
      const ConeReading reading = any_reading(random);
      inserter.insert(reading, grid);
      insert_cell_by_cell(params, reading, expected);
    }
    expect_same(grid, expected);
  }
}

TEST(ConeInsertion, MakesTheSameBytesAlongTheAxesAndDiagonals) {
  ConeInsertionParams params;
  params.half_opening_rad = 0.7;
  params.free_centilogits = {-10, -30};  // More evidence farther off the axis.
  params.arc_centilogits = {5, 10, 15, 20, 25, 30, 35, 40};
  OccupancyGrid grid;
  OccupancyGrid expected;
  ConeInserter inserter(params, grid);
  for (int eighth = -4; eighth <= 4; ++eighth) {
    const ConeReading reading{Pose2(0.02, -1.61, eighth * std::numbers::pi / 4.0), 2.1, 2.1};
    inserter.insert(reading, grid);
    insert_cell_by_cell(params, reading, expected);
  }
  expect_same(grid, expected);
}

TEST(ConeInsertion, MakesTheSameBytesAThousandCellsAway) {
  ConeInsertionParams params;
  params.half_opening_rad = 0.2;
  OccupancyGrid grid({.resolution_m = 0.005});
  OccupancyGrid expected({.resolution_m = 0.005});
  ConeInserter inserter(params, grid);
  const ConeReading reading{Pose2(0.3012, -0.7023, 0.1), 4.9, 4.9};
  inserter.insert(reading, grid);
  insert_cell_by_cell(params, reading, expected);
  expect_same(grid, expected);
}

TEST(ConeInsertion, MakesNoTileWithoutEvidence) {
  std::mt19937 random(12);
  const ConeInsertionParams params;
  for (int i = 0; i < 100; ++i) {
    OccupancyGrid grid;
    OccupancyGrid expected;
    const ConeReading reading = any_reading(random);
    ConeInserter(params, grid).insert(reading, grid);
    insert_cell_by_cell(params, reading, expected);
    EXPECT_THAT(grid.tiles_changed_since(0),
                testing::UnorderedElementsAreArray(expected.tiles_changed_since(0)));
  }
}

TEST(ConeInsertion, PaintsFreeFloorUpToTheArc) {
  OccupancyGrid grid({.resolution_m = 0.1});
  ConeInserter inserter({.half_opening_rad = 0.3,
                         .free_centilogits = {-200},
                         .arc_centilogits = {200},
                         .half_thickness_m = 0.05},
                        grid);
  inserter.insert({Pose2(0.05, 0.05, 0.0), 0.95, 0.9}, grid);
  std::string drawn;
  for (std::int32_t y = 3; y >= -3; --y) {
    for (std::int32_t x = 0; x <= 10; ++x) {
      const CellState state = grid.state({x, y});
      drawn += state == CellState::kFree ? '.' : state == CellState::kOccupied ? '#' : ' ';
    }
    drawn += '\n';
  }
  EXPECT_EQ(drawn,
            "           \n"
            "       ..# \n"
            "    .....# \n"
            ".........# \n"
            "    .....# \n"
            "       ..# \n"
            "           \n");
}

TEST(ConeInsertion, SaysNothingOfTheFloorWithoutAFreeRange) {
  OccupancyGrid grid;
  ConeInserter inserter({}, grid);
  inserter.insert({Pose2(0.0, 0.0, 1.0), -1.0, std::nullopt}, grid);
  EXPECT_TRUE(grid.bounds().empty());
  EXPECT_TRUE(grid.tiles_changed_since(0).empty());
}

TEST(ConeInsertion, TakesNoNumberThatIsNotFinite) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  OccupancyGrid grid;
  ConeInserter inserter({}, grid);
  inserter.insert({Pose2(nan, 0.0, 0.0), 1.0, 1.0}, grid);
  inserter.insert({Pose2(0.0, 0.0, nan), 1.0, 1.0}, grid);
  inserter.insert({Pose2(0.0, 0.0, 0.0), infinity, 1.0}, grid);
  inserter.insert({Pose2(0.0, 0.0, 0.0), 1.0, nan}, grid);
  EXPECT_TRUE(grid.bounds().empty());
}

TEST(ConeInsertion, RefusesParametersWithoutSense) {
  const OccupancyGrid grid;
  EXPECT_THROW(ConeInserter({.half_opening_rad = 0.0}, grid), std::invalid_argument);
  EXPECT_THROW(ConeInserter({.half_opening_rad = 1.6}, grid), std::invalid_argument);
  EXPECT_THROW(ConeInserter({.free_centilogits = {40}}, grid), std::invalid_argument);
  EXPECT_THROW(ConeInserter({.arc_centilogits = {-40}}, grid), std::invalid_argument);
  EXPECT_THROW(ConeInserter({.arc_centilogits = {40, 0, 40}}, grid), std::invalid_argument);
  EXPECT_THROW(ConeInserter({.free_centilogits = std::vector<int>(9, -40)}, grid),
               std::invalid_argument);
  EXPECT_THROW(ConeInserter({.reach_m = 100.1}, grid), std::invalid_argument);
  EXPECT_THROW(ConeInserter({.half_thickness_m = -0.1}, grid), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::mapping
