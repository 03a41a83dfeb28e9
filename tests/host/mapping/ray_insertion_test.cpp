// SPDX-License-Identifier: MIT
#include "host/mapping/ray_insertion.hpp"

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "host/geometry/unit_vector.hpp"

namespace echomap::mapping {
namespace {

using geometry::CellIndex;
using geometry::Pose2;

std::string drawing_of(const OccupancyGrid& grid, CellIndex low, CellIndex high) {
  std::string drawn;
  for (std::int32_t y = high.y; y >= low.y; --y) {
    for (std::int32_t x = low.x; x <= high.x; ++x) {
      const auto evidence = grid.centilogits({x, y});
      drawn += !evidence ? ' ' : *evidence < 0 ? '.' : '#';
    }
    drawn += '\n';
  }
  return drawn;
}

TEST(RayInsertion, DrawsWhatAScanSaw) {
  OccupancyGrid grid({.resolution_m = 1.0});
  RayInserter inserter;
  const std::vector<Ray> rays{{{5.0, 0.0}, true}, {{4.0, 2.0}, true}, {{0.0, 3.0}, false}};
  inserter.insert(Pose2(0.5, 0.4, 0.0), rays, grid);
  EXPECT_EQ(drawing_of(grid, {-1, -1}, {6, 4}),
            "        \n"
            " .      \n"
            " .  .#  \n"
            " ....   \n"
            " .....# \n"
            "        \n");
}

TEST(RayInsertion, CountsACellOnceAScanAndAHitBeforeAPass) {
  OccupancyGrid grid;
  RayInserter inserter;
  const std::vector<Ray> rays{
      {{1.0, 0.0}, true}, {{1.0, 0.0}, true}, {{2.0, 0.0}, false}, {{3.0, 0.0}, true}};
  inserter.insert(Pose2(0.02, 0.02, 0.0), rays, grid);
  EXPECT_EQ(grid.centilogits({0, 0}), -40);
  EXPECT_EQ(grid.centilogits({10, 0}), -40);
  EXPECT_EQ(grid.centilogits({20, 0}), 85);
  EXPECT_EQ(grid.centilogits({60, 0}), 85);
  EXPECT_EQ(grid.revision(), 1U);
}

TEST(RayInsertion, TurnsTheScanWithTheSensor) {
  OccupancyGrid grid;
  RayInserter inserter;
  inserter.insert(Pose2(-3.01, 2.02, 1.2), std::vector<Ray>{{{2.0, 0.5}, true}}, grid);
  const Eigen::Vector2d end_m = Pose2(-3.01, 2.02, 1.2) * Eigen::Vector2d(2.0, 0.5);
  EXPECT_EQ(grid.state(grid.cell_at(end_m)), CellState::kOccupied);
  EXPECT_EQ(grid.bounds().max, grid.cell_at(end_m));
  EXPECT_EQ(grid.bounds().min, grid.cell_at({-3.01, 2.02}));
}

TEST(RayInsertion, BoundsExactlyTheTouchedCells) {
  std::mt19937 random(9);
  for (int scan = 0; scan < 20; ++scan) {
    OccupancyGrid grid;
    RayInserter inserter;
    std::vector<Ray> rays;
    for (int i = 0; i < 30; ++i) {
      const double range_m = 0.2 + static_cast<double>(random() % 800) / 100.0;
      rays.push_back({range_m * geometry::unit_vector(0.21 * i), random() % 2 == 0});
    }
    inserter.insert(Pose2(static_cast<double>(random() % 100), -3.0, 0.1 * scan), rays, grid);
    OccupancyGrid cell_by_cell;
    const CellBounds bounds = grid.bounds();
    for (std::int32_t y = bounds.min.y - 70; y <= bounds.max.y + 70; ++y) {
      for (std::int32_t x = bounds.min.x - 70; x <= bounds.max.x + 70; ++x) {
        cell_by_cell.add({x, y}, grid.centilogits({x, y}).value_or(0));
      }
    }
    EXPECT_EQ(cell_by_cell.bounds().min, bounds.min);
    EXPECT_EQ(cell_by_cell.bounds().max, bounds.max);
    EXPECT_EQ(cell_by_cell.tiles_changed_since(0).size(), grid.tiles_changed_since(0).size());
  }
}

/// Rays of a turning sensor, among them short ones, equal ones and none at all.
std::vector<Ray> ragged_scan(std::mt19937& random) {
  const auto beams = static_cast<int>(1 + random() % 500);
  const double beam_width_rad = static_cast<double>(1 + random() % 720) * 0.0175;
  const double turn = random() % 2 == 0 ? 1.0 : -1.0;
  const double max_m = 0.1 + static_cast<double>(random() % 800) / 100.0;
  const auto seldom = static_cast<int>(2 + random() % 300);
  const auto is_seldom = [&] { return static_cast<int>(random() % 1000) * seldom < 1000; };
  std::vector<Ray> rays;
  for (int i = 0; i < beams; ++i) {
    const double bearing_rad = turn * beam_width_rad * (i - (is_seldom() ? 1 : 0)) / beams;
    const double share = is_seldom() ? static_cast<double>(random() % 100) / 100.0 : 1.0;
    const double ripple = 1.0 + 0.2 * std::sin(7.0 * bearing_rad);
    rays.push_back({share * ripple * max_m * geometry::unit_vector(bearing_rad), false});
    if (is_seldom()) {
      rays.back().end_m.x() = std::numeric_limits<double>::quiet_NaN();
    }
  }
  return rays;
}

TEST(RayInsertion, TouchesTheCellsOfItsRaysInsertedOneByOne) {
  std::mt19937 random(13);
  for (int scan = 0; scan < 300; ++scan) {
    OccupancyGrid grid;
    OccupancyGrid one_by_one;
    RayInserter inserter;
    const Pose2 pose(static_cast<double>(random() % 1000) / 331.0, -1.0, 0.1 * scan);
    const std::vector<Ray> rays = ragged_scan(random);
    inserter.insert(pose, rays, grid);
    for (const Ray& ray : rays) {
      inserter.insert(pose, {&ray, 1}, one_by_one);
    }
    ASSERT_EQ(grid.bounds().min, one_by_one.bounds().min) << scan;
    ASSERT_EQ(grid.bounds().max, one_by_one.bounds().max) << scan;
    const CellBounds& bounds = grid.bounds();
    for (std::int32_t y = bounds.min.y - 64; y <= bounds.max.y + 64; ++y) {
      for (std::int32_t x = bounds.min.x - 64; x <= bounds.max.x + 64; ++x) {
        ASSERT_EQ(grid.centilogits({x, y}).has_value(), one_by_one.centilogits({x, y}).has_value())
            << scan << ": " << x << ' ' << y;
      }
    }
  }
}

TEST(RayInsertion, CutsARayThatIsTooLong) {
  OccupancyGrid grid;
  RayInserter inserter;
  inserter.insert(Pose2(), std::vector<Ray>{{{-1e9, 0.0}, true}}, grid);
  EXPECT_EQ(grid.bounds().columns(), static_cast<int>(kMaxRayCells) + 1);
  EXPECT_EQ(grid.centilogits(grid.bounds().min), -40);
}

TEST(RayInsertion, TakesNoNumberThatIsNotFinite) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  OccupancyGrid grid;
  RayInserter inserter;
  inserter.insert(Pose2(nan, 0.0, 0.0), std::vector<Ray>{{{1.0, 0.0}, true}}, grid);
  inserter.insert(Pose2(), std::vector<Ray>{{{nan, 0.0}, true}, {{infinity, 0.0}, true}}, grid);
  EXPECT_TRUE(grid.bounds().empty());
  EXPECT_EQ(grid.revision(), 0U);
}

TEST(RayInsertion, RefusesEvidenceThatSaysNothing) {
  EXPECT_THROW(RayInserter({.hit_centilogits = 4}), std::invalid_argument);
  EXPECT_THROW(RayInserter({.free_centilogits = 40}), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::mapping
