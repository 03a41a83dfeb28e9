// SPDX-License-Identifier: MIT
#include "host/evaluation/path_agreement.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "host/geometry/polygon.hpp"
#include "tests/host/evaluation/drawn_truth.hpp"
#include "tests/support/drawn_map.hpp"

namespace echomap::evaluation {
namespace {

using geometry::Pose2;
using mapping::CellState;
using mapping::RasterMap;

constexpr double kRadiusM = 0.09;

void fill(RasterMap& map, const mapping::CellBounds& cells, CellState state) {
  for (int y = cells.min.y; y <= cells.max.y; ++y) {
    for (int x = cells.min.x; x <= cells.max.x; ++x) {
      map.set({x, y}, state);
    }
  }
}

/// A room of 2 m x 1 m at the origin in cells of 5 cm, its walls the cells around it.
RasterMap map_of_room() {
  RasterMap map(42, 22, 0.05, {-0.05, -0.05});
  fill(map, {{0, 0}, {41, 21}}, CellState::kOccupied);
  fill(map, {{1, 1}, {40, 20}}, CellState::kFree);
  return map;
}

MapTruth empty_room() {
  MapTruth truth{map_of_room(), {}};
  add_ring({{0.0, 0.0}, {2.0, 0.0}, {2.0, 1.0}, {0.0, 1.0}}, truth);
  return truth;
}

/// With a box of 0.2 m x 0.2 m in the middle.
MapTruth with_box() {
  MapTruth truth = empty_room();
  fill(truth.cells, {{19, 9}, {22, 12}}, CellState::kUnknown);
  add_ring({{0.9, 0.4}, {0.9, 0.6}, {1.1, 0.6}, {1.1, 0.4}}, truth);
  return truth;
}

TEST(PathAgreement, IsFullForTheTruthItself) {
  const auto agreement = score_paths(map_of_room(), Pose2(), empty_room(), kRadiusM);
  EXPECT_EQ(agreement.pairs, 200U);
  EXPECT_EQ(agreement.paths, 200U);
  EXPECT_EQ(agreement.collisions, 0U);
}

TEST(PathAgreement, GoesAroundWhatTheMapShows) {
  RasterMap map = map_of_room();
  fill(map, {{19, 9}, {22, 12}}, CellState::kOccupied);
  const auto agreement = score_paths(map, Pose2(), with_box(), kRadiusM);
  EXPECT_EQ(agreement.paths, 200U);
  EXPECT_EQ(agreement.collisions, 0U);
}

TEST(PathAgreement, CollidesWithWhatTheMapHasErased) {
  const auto agreement = score_paths(map_of_room(), Pose2(), with_box(), kRadiusM);
  EXPECT_EQ(agreement.paths, 200U);
  EXPECT_GT(agreement.collisions, 30U);
  EXPECT_LT(agreement.collisions, 170U) << "many pairs lie on one side of the box";
}

TEST(PathAgreement, FindsNoPathThroughAWallThatIsNone) {
  RasterMap map = map_of_room();
  fill(map, {{20, 1}, {20, 20}}, CellState::kOccupied);
  const auto agreement = score_paths(map, Pose2(), empty_room(), kRadiusM);
  // Half of the pairs lie on one side; ends within 10 cm of the open floor count as reached.
  EXPECT_GT(agreement.paths, 60U);
  EXPECT_LT(agreement.paths, 120U);
  EXPECT_EQ(agreement.collisions, 0U);
}

TEST(PathAgreement, KeepsTenCentimetresOffTheUnknown) {
  // A gap of 3 cells of floor between unknown ones leaves its middle row, 10 cm from the centres of
  // those beyond; one of 2 leaves none.
  for (const int gap : {3, 2}) {
    RasterMap map = map_of_room();
    fill(map, {{20, 1}, {20, 20}}, CellState::kUnknown);
    fill(map, {{20, 9}, {20, 8 + gap}}, CellState::kFree);
    const auto agreement = score_paths(map, Pose2(), empty_room(), kRadiusM);
    EXPECT_EQ(agreement.paths > 150U, gap == 3) << agreement.paths;
  }
}

TEST(PathAgreement, SamplesOnlyWhatTheTruthConnects) {
  MapTruth truth = empty_room();
  // A wall shuts off the right quarter, where the map knows of no floor.
  fill(truth.cells, {{31, 1}, {31, 20}}, CellState::kOccupied);
  truth.walls.push_back({{1.525, 0.0}, {1.525, 1.0}});
  RasterMap map = map_of_room();
  fill(map, {{31, 1}, {31, 20}}, CellState::kOccupied);
  fill(map, {{32, 1}, {40, 20}}, CellState::kUnknown);
  const auto agreement = score_paths(map, Pose2(), truth, kRadiusM);
  EXPECT_EQ(agreement.paths, 200U);
}

TEST(PathAgreement, PlacesTheMapInTheWorld) {
  RasterMap map(42, 22, 0.05, {-1.05, -0.55});
  fill(map, {{0, 0}, {41, 21}}, CellState::kOccupied);
  fill(map, {{1, 1}, {40, 20}}, CellState::kFree);
  const auto placed = score_paths(map, {1.0, 0.5, 0.0}, empty_room(), kRadiusM);
  EXPECT_EQ(placed.paths, 200U);
  EXPECT_EQ(placed.collisions, 0U);
  // The walls of the left side then stand where pairs begin, too far from floor.
  EXPECT_LT(score_paths(map, {1.3, 0.5, 0.0}, empty_room(), kRadiusM).paths, 195U);
}

TEST(PathAgreement, HasNoPairsWhereTheRobotDoesNotFit) {
  EXPECT_EQ(score_paths(map_of_room(), Pose2(), empty_room(), 0.6).pairs, 0U);
  EXPECT_THROW(score_paths(map_of_room(), Pose2(), empty_room(), 0.0), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::evaluation
