// SPDX-License-Identifier: MIT
#include "host/mapping/polygon_map.hpp"

#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/host/mapping/outlines.hpp"
#include "tests/support/drawn_map.hpp"
#include "tests/support/random_polygon.hpp"

namespace echomap::mapping {
namespace {

using geometry::Polygon;
using tests::map_from;

/// The test of Mukherjee et al., section V-C: on the inner side of every side of the polygon of the
/// non-reflex corners, and in no polygon of a run of reflex corners with its two neighbours.
bool accepted_by_the_paper(const Polygon& outline, const Eigen::Vector2d& point) {
  Polygon simple;
  std::vector<Polygon> cut;
  const std::size_t count = outline.size();
  for (std::size_t i = 0; i < count; ++i) {
    if (corner_kind(outline, i) == CornerKind::kNonReflex) {
      simple.push_back(outline[i]);
      continue;
    }
    if (corner_kind(outline, i - 1) == CornerKind::kNonReflex) {
      cut.push_back({outline[i - 1]});
    }
    cut.back().push_back(outline[i]);
    if (corner_kind(outline, (i + 1) % count) == CornerKind::kNonReflex) {
      cut.back().push_back(outline[(i + 1) % count]);
    }
  }
  for (std::size_t i = 0; i < simple.size(); ++i) {
    const auto [from, to] = geometry::side(simple, i);
    if (geometry::cross(to - from, point - from) <= 0.0) {
      return false;
    }
  }
  return std::none_of(
      cut.begin(), cut.end(), [&](const Polygon& part) { return geometry::contains(part, point); });
}

TEST(PolygonMap, TellsReflexFromNonReflexCorners) {
  const PolygonMap map(kL);
  std::vector<std::size_t> reflex;
  for (std::size_t i = 0; i < map.outline_m().size(); ++i) {
    if (corner_kind(map.outline_m(), i) == CornerKind::kReflex) {
      reflex.push_back(i);
    }
  }
  EXPECT_EQ(reflex, std::vector<std::size_t>{3});
}

TEST(PolygonMap, HasTheFloorToTheLeftWhateverSenseItWasGivenIn) {
  const PolygonMap map({kL.rbegin(), kL.rend()}, {{{0.5, 0.5}, {1, 0.5}, {1, 1}, {0.5, 1}}});
  EXPECT_GT(geometry::signed_area_m2(map.outline_m()), 0.0);
  EXPECT_LT(geometry::signed_area_m2(map.holes_m()[0]), 0.0);
  EXPECT_DOUBLE_EQ(map.area_m2(), 8.0 - 0.25);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(corner_kind(map.holes_m()[0], i), CornerKind::kReflex) << "an obstacle's corner";
  }
}

TEST(PolygonMap, FloorIsInsideOfTheOutlineAndOutsideOfHoles) {
  const PolygonMap map(kL, {{{0.5, 0.5}, {1, 0.5}, {1, 1}, {0.5, 1}}});
  EXPECT_TRUE(map.contains({0.2, 2.8}));
  EXPECT_FALSE(map.contains({0.7, 0.7}));
  EXPECT_FALSE(map.contains({0.5, 0.7})) << "on a wall";
  EXPECT_FALSE(map.contains({3.0, 2.0}));
}

TEST(PolygonMap, AcceptsThePointsThatThePapersTwoStepsAccept) {
  const PolygonMap map(kL);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place_m(-0.5, 4.5);
  int inside = 0;
  for (int i = 0; i < 5000; ++i) {
    const Eigen::Vector2d point(place_m(random), place_m(random));
    EXPECT_EQ(map.contains(point), accepted_by_the_paper(map.outline_m(), point))
        << point.transpose();
    inside += map.contains(point) ? 1 : 0;
  }
  EXPECT_GT(inside, 500);
}

TEST(PolygonMap, RefusesRingsThatAreNoFloor) {
  const Polygon beside{{5, 5}, {6, 5}, {6, 6}, {5, 6}};
  const Polygon across{{1, 0.5}, {3, 0.5}, {3, 2}, {1, 2}};
  EXPECT_THROW(PolygonMap({{0, 0}, {1, 1}}), std::invalid_argument);
  EXPECT_THROW(PolygonMap({{0, 0}, {1, 1}, {1, 0}, {0, 1}}), std::invalid_argument);
  EXPECT_THROW(PolygonMap(kL, {beside}), std::invalid_argument);
  EXPECT_THROW(PolygonMap(kL, {across}), std::invalid_argument);
}

TEST(PolygonFromRaster, StraightensTheStairsOfASlantedWall) {
  RasterMap map(80, 60, 0.05, {0.0, 0.0});
  const PolygonMap room({{0.2, 0.2}, {3.8, 0.2}, {3.8, 1.5}, {2.3, 2.8}, {0.2, 2.8}});
  for (int y = 0; y < 60; ++y) {
    for (int x = 0; x < 80; ++x) {
      map.set({x, y},
              room.contains(map.center_m({x, y})) ? CellState::kFree : CellState::kOccupied);
    }
  }
  const auto polygon = polygon_from_raster(map);
  ASSERT_TRUE(polygon);
  EXPECT_EQ(polygon->outline_m().size(), 5U);
  EXPECT_NEAR(polygon->area_m2(), room.area_m2(), 0.02 * room.area_m2());
}

TEST(PolygonFromRaster, LeavesOutHolesOfACellOrTwo) {
  const auto map = map_from({"......", ".##...", ".##. .", "......"}, 0.1);
  EXPECT_EQ(polygon_from_raster(map, {0.0, 0.02})->holes_m().size(), 1U);
  EXPECT_EQ(polygon_from_raster(map, {0.0, 0.0})->holes_m().size(), 2U);
  EXPECT_EQ(polygon_from_raster(map, {0.0, 0.05})->holes_m().size(), 0U);
}

TEST(PolygonFromRaster, WithoutFloorIsEmpty) {
  EXPECT_FALSE(polygon_from_raster(map_from({"# #"})));
}

TEST(PolygonFromRaster, NeverHasAFaultAndStaysNearTheFloor) {
  std::mt19937 random(6);
  for (int trial = 0; trial < 100; ++trial) {
    const PolygonMap room(tests::random_polygon(random, 3 + static_cast<std::size_t>(trial % 30)));
    RasterMap map(140, 140, 0.05, {-3.5, -3.5});
    int free = 0;
    for (int y = 0; y < 140; ++y) {
      for (int x = 0; x < 140; ++x) {
        if (room.contains(map.center_m({x, y})) && random() % 50 != 0) {
          map.set({x, y}, CellState::kFree);
          ++free;
        }
      }
    }
    const auto polygon = polygon_from_raster(map);
    ASSERT_TRUE(polygon) << trial;
    EXPECT_FALSE(geometry::polygon_fault(polygon->outline_m())) << trial;
    EXPECT_NEAR(polygon->area_m2(), free * 0.0025, 0.1 * free * 0.0025 + 0.3) << trial;
  }
}

TEST(PolygonMapParams, AreNotNegative) {
  EXPECT_THROW(polygon_from_raster(map_from({"."}), {-1.0, 0.0}), std::invalid_argument);
  EXPECT_THROW(polygon_from_raster(map_from({"."}), {0.0, -1.0}), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::mapping
