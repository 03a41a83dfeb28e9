// SPDX-License-Identifier: MIT
#include "host/mapping/occupancy_grid.hpp"

#include <algorithm>
#include <map>
#include <random>
#include <stdexcept>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace echomap::mapping {
namespace {

using geometry::CellIndex;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;

TEST(OccupancyGrid, KnowsNothingAtFirst) {
  const OccupancyGrid grid;
  EXPECT_EQ(grid.state({0, 0}), CellState::kUnknown);
  EXPECT_FALSE(grid.probability({5, -5}).has_value());
  EXPECT_TRUE(grid.bounds().empty());
}

TEST(OccupancyGrid, CoversHalfOpenSquares) {
  const OccupancyGrid grid;
  EXPECT_EQ(grid.cell_at({0.0, 0.0}), (CellIndex{0, 0}));
  EXPECT_EQ(grid.cell_at({0.0499, -0.0001}), (CellIndex{0, -1}));
  EXPECT_EQ(grid.cell_at({-0.051, 0.1}), (CellIndex{-2, 2}));
  EXPECT_NEAR((grid.center_m({-1, 2}) - Eigen::Vector2d(-0.025, 0.125)).norm(), 0.0, 1e-12);
}

TEST(OccupancyGrid, LeavesEveryUntouchedCellUnknownHoweverItGrows) {
  std::mt19937 random(3);
  std::map<CellIndex, int> expected;
  OccupancyGrid grid;
  for (int i = 0; i < 300; ++i) {
    const CellIndex cell{static_cast<int>(random() % 200) - 100,
                         static_cast<int>(random() % 200) - 100};
    grid.add(cell, 10);
    expected[cell] += 10;
  }
  for (int y = -140; y < 140; ++y) {
    for (int x = -140; x < 140; ++x) {
      const auto found = expected.find({x, y});
      if (found == expected.end()) {
        ASSERT_FALSE(grid.centilogits({x, y}).has_value()) << x << ' ' << y;
      } else {
        ASSERT_EQ(grid.centilogits({x, y}), found->second) << x << ' ' << y;
      }
    }
  }
}

TEST(OccupancyGrid, AddsEvidenceInAnyOrder) {
  std::vector<std::pair<CellIndex, int>> evidence;
  for (int i = 0; i < 60; ++i) {
    evidence.emplace_back(CellIndex{i % 5 - 2, i % 3 - 1}, i % 2 == 0 ? -30 : 20);
  }
  OccupancyGrid forward;
  OccupancyGrid backward;
  for (const auto& [cell, centilogits] : evidence) {
    forward.add(cell, centilogits);
  }
  std::reverse(evidence.begin(), evidence.end());
  for (const auto& [cell, centilogits] : evidence) {
    backward.add(cell, centilogits);
    EXPECT_TRUE(forward.centilogits(cell).has_value());
  }
  for (const auto& [cell, centilogits] : evidence) {
    EXPECT_EQ(forward.centilogits(cell), backward.centilogits(cell));
  }
}

TEST(OccupancyGrid, TakesNoEvidenceAsNone) {
  OccupancyGrid grid;
  grid.add({1, 1}, 0);
  EXPECT_FALSE(grid.centilogits({1, 1}).has_value());
}

TEST(OccupancyGrid, RoundsEvidenceToWholeSteps) {
  OccupancyGrid grid;
  grid.add({0, 0}, 52);
  grid.add({1, 0}, -53);
  grid.add({2, 0}, 2);
  EXPECT_EQ(grid.centilogits({0, 0}), 50);
  EXPECT_EQ(grid.centilogits({1, 0}), -55);
  EXPECT_FALSE(grid.centilogits({2, 0}).has_value());
  EXPECT_EQ(grid.revision(), 2U);
}

TEST(OccupancyGrid, HoldsEveryEvidenceThatAByteCan) {
  OccupancyGrid grid({.clamp_centilogits = 639});
  for (int steps = -127; steps <= 127; ++steps) {
    grid.add({steps, 0}, steps == 0 ? 5 : 5 * steps);
    grid.add({steps, 0}, steps == 0 ? -5 : 0);
    EXPECT_EQ(grid.centilogits({steps, 0}), 5 * steps);
  }
  grid.add({-127, 0}, 100000);
  grid.add({127, 0}, -100000);
  EXPECT_EQ(grid.centilogits({-127, 0}), 635);
  EXPECT_EQ(grid.centilogits({127, 0}), -635);
}

TEST(OccupancyGrid, HasADecisionOnlyBeyondTheThresholds) {
  OccupancyGrid grid;
  grid.add({0, 0}, -140);  // p = 0.198
  EXPECT_EQ(grid.state({0, 0}), CellState::kUnknown);
  grid.add({0, 0}, -5);  // p = 0.190
  EXPECT_EQ(grid.state({0, 0}), CellState::kFree);
  grid.add({1, 0}, 60);  // p = 0.646
  EXPECT_EQ(grid.state({1, 0}), CellState::kUnknown);
  grid.add({1, 0}, 5);  // p = 0.657
  EXPECT_EQ(grid.state({1, 0}), CellState::kOccupied);
}

TEST(OccupancyGrid, CanChangeItsMind) {
  OccupancyGrid grid;
  for (int i = 0; i < 1000; ++i) {
    grid.add({0, 0}, -300);
  }
  EXPECT_EQ(grid.centilogits({0, 0}), -500);
  grid.add({0, 0}, 600);
  EXPECT_EQ(grid.state({0, 0}), CellState::kOccupied);
}

TEST(OccupancyGrid, TurnsLogOddsIntoAProbability) {
  OccupancyGrid grid;
  grid.add({0, 0}, 110);
  EXPECT_NEAR(grid.probability({0, 0}).value(), 0.7503, 1e-4);
}

TEST(OccupancyGrid, BoundsWhatWasTouched) {
  OccupancyGrid grid;
  grid.add({-40, 3}, 10);
  grid.add({7, -90}, 10);
  const auto bounds = grid.bounds();
  EXPECT_EQ(bounds.min, (CellIndex{-40, -90}));
  EXPECT_EQ(bounds.max, (CellIndex{7, 3}));
  EXPECT_EQ(bounds.columns(), 48);
  EXPECT_EQ(bounds.rows(), 94);
}

TEST(OccupancyGrid, TellsTheTilesThatChanged) {
  OccupancyGrid grid;
  grid.add({0, 0}, 50);
  grid.add({63, 63}, 50);
  grid.add({-1, 64}, 50);
  EXPECT_THAT(grid.tiles_changed_since(0), UnorderedElementsAre(CellIndex{0, 0}, CellIndex{-1, 1}));
  const auto seen = grid.revision();
  EXPECT_THAT(grid.tiles_changed_since(seen), IsEmpty());
  grid.add({-64, 127}, -50);
  grid.add({5, 5}, 0);
  EXPECT_THAT(grid.tiles_changed_since(seen), ElementsAre(CellIndex{-1, 1}));
}

TEST(OccupancyGrid, HoldsAHallOfAHundredMetresInTenMegabytes) {
  OccupancyGrid grid({.resolution_m = 0.05});
  for (int y = -1000; y < 1000; ++y) {
    for (int x = -1000; x < 1000; ++x) {
      grid.add({x, y}, -50);
    }
  }
  EXPECT_EQ(grid.bounds().columns(), 2000);
  EXPECT_LT(grid.memory_bytes(), 5'000'000U);
}

TEST(OccupancyGrid, PaysNothingForGroundBetweenFarPlaces) {
  OccupancyGrid grid;
  grid.add({-1'000'000'000, 7}, 50);
  grid.add({1'000'000'000, -1'000'000'000}, 50);
  EXPECT_LT(grid.memory_bytes(), 20'000U);
  EXPECT_EQ(grid.centilogits({-1'000'000'000, 7}), 50);
  EXPECT_EQ(grid.state({0, 0}), CellState::kUnknown);
}

TEST(OccupancyGrid, IsCopiedWhole) {
  OccupancyGrid grid;
  grid.add({3, 3}, 100);
  const OccupancyGrid copy = grid;
  grid.add({3, 3}, -50);
  EXPECT_EQ(copy.centilogits({3, 3}), 100);
  EXPECT_EQ(grid.centilogits({3, 3}), 50);
}

TEST(OccupancyGrid, RefusesParametersWithoutSense) {
  EXPECT_THROW(OccupancyGrid({.resolution_m = 0.0}), std::invalid_argument);
  EXPECT_THROW(OccupancyGrid({.clamp_centilogits = 4}), std::invalid_argument);
  EXPECT_THROW(OccupancyGrid({.clamp_centilogits = 640}), std::invalid_argument);
  EXPECT_THROW(OccupancyGrid({.free_threshold = 0.7}), std::invalid_argument);
}

TEST(NewlyFreeArea, CountsWhatWasUnknownAndIsFree) {
  OccupancyGrid before;
  before.add({0, 0}, -200);
  before.add({1, 0}, 200);
  OccupancyGrid now = before;
  now.add({1, 0}, -400);  // was occupied: nothing new
  now.add({2, 0}, -200);
  now.add({3, 0}, 200);
  EXPECT_NEAR(newly_free_area_m2(before, now), 0.0025, 1e-12);
  EXPECT_EQ(newly_free_area_m2(before, OccupancyGrid()), 0.0);
}

}  // namespace
}  // namespace echomap::mapping
