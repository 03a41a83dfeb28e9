// SPDX-License-Identifier: MIT
#include "host/mapping/outline_lines.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "host/mapping/raster_outline.hpp"
#include "tests/host/mapping/outlines.hpp"

namespace echomap::mapping {
namespace {

using geometry::Segment;

const OutlineLineParams kLineParams;

/// Floor from (0, 0) to (2, 1), occupied below it, unknown elsewhere.
RasterMap half_known_room() {
  RasterMap map(60, 40, 0.05, {-0.5, -0.5});
  for (int y = 9; y < 30; ++y) {
    for (int x = 10; x < 50; ++x) {
      map.set({x, y}, y == 9 ? CellState::kOccupied : CellState::kFree);
    }
  }
  return map;
}

OutlineLine fitted(const Segment& wall) {
  return outline_lines(border_of(half_known_room()), {wall}, kLineParams).front();
}

double misfit_of(const OutlineLine& line, const BorderPoint& point) {
  return misfits({line}, point, half_known_room(), kLineParams).front();
}

constexpr double kAcross = 1.0;

BorderPoint below(double x_m, double y_m) { return {{x_m, y_m}, {0, -kAcross}, true}; }
BorderPoint unknown(double x_m, double y_m) { return {{x_m, y_m}, {0, -kAcross}, false}; }

TEST(OutlineLines, AreOfWallsAndOfTheBorder) {
  const auto lines =
      outline_lines(border_of(half_known_room()), {{{0.2, 0}, {1.8, 0}}}, kLineParams);
  EXPECT_TRUE(lines.front().is_fitted);
  EXPECT_EQ(lines.front().cost_m, 0.0);
  const auto own = std::count_if(lines.begin(), lines.end(), [](const OutlineLine& line) {
    return line.cost_m == kLineParams.own_direction_m;
  });
  EXPECT_EQ(own, 4) << "sides of the border";
  const auto walls = std::count_if(lines.begin(), lines.end(), [](const OutlineLine& line) {
    return line.is_wall && line.cost_m == kLineParams.own_direction_m;
  });
  EXPECT_EQ(walls, 1) << "with occupied cells behind it";
}

TEST(OutlineLines, TurnToTheDirectionsOfWallsWhereTheBorderMayHaveThem) {
  const auto with_wall = [&](const Segment& wall) {
    const auto lines = outline_lines(border_of(half_known_room()), {wall}, kLineParams);
    return std::count_if(lines.begin(), lines.end(), [](const OutlineLine& line) {
      return line.cost_m == kLineParams.own_line_m;
    });
  };
  EXPECT_EQ(with_wall({{0.2, 0}, {1.8, 0.03}}), 4);
  EXPECT_EQ(with_wall({{0.2, 0}, {1.8, 1.6}}), 0);
}

TEST(OutlineLines, OfNothingAreNone) { EXPECT_TRUE(outline_lines({}, {}, kLineParams).empty()); }

TEST(Misfit, GrowsWithTheSquareOfTheDistanceBeyondACell) {
  const OutlineLine wall = fitted({{0, 0}, {2, 0}});
  EXPECT_EQ(misfit_of(wall, below(1, 0.04)), 0.0);
  EXPECT_NEAR(misfit_of(wall, below(1, 0.10)), 0.25, 1e-9);
  EXPECT_NEAR(misfit_of(wall, below(1, -0.10)), 0.25, 1e-9);
  EXPECT_EQ(misfit_of(wall, below(1, 0.3)), 1.0);
}

TEST(Misfit, IsFullFarAlongTheLine) {
  const OutlineLine wall = fitted({{0, 0}, {0.5, 0}});
  EXPECT_EQ(misfit_of(wall, below(0.5 + 0.9 * kLineParams.reach_m, 0)), 0.0);
  EXPECT_EQ(misfit_of(wall, below(0.5 + 1.1 * kLineParams.reach_m, 0)), 1.0);
}

TEST(Misfit, BridgesTheUnknownBeforeAWall) {
  // Beyond the upper border, at y = 1, all is unknown.
  const OutlineLine wall = fitted({{2, 1.4}, {0, 1.4}});
  const BorderPoint unknown_m{{1, 1}, {0, kAcross}, false};
  EXPECT_EQ(misfit_of(wall, unknown_m), kLineParams.bridged_share);
  EXPECT_EQ(misfit_of(wall, {{1, 1}, {0, kAcross}, true}), 1.0) << "occupied";
  EXPECT_EQ(misfit_of(fitted({{2, 1.9}, {0, 1.9}}), unknown_m), 1.0) << "too deep";
  EXPECT_EQ(misfit_of(fitted({{0, -0.3}, {2, -0.3}}), unknown(1, 0)), 1.0)
      << "through occupied cells";
}

TEST(Misfit, OfTheUnknownIsLessAtAWallThanElsewhere) {
  OutlineLine line = fitted({{0, 0}, {2, 0}});
  EXPECT_EQ(misfit_of(line, unknown(1, 0)), kLineParams.bridged_share);
  line.is_wall = false;
  EXPECT_EQ(misfit_of(line, unknown(1, 0)), kLineParams.unknown_share);
}

TEST(Misfit, OfTheFloorBehindAWallIsLessUnlessAWallWasFittedThere) {
  const OutlineLine wall = fitted({{0, 0}, {2, 0}});
  const OutlineLine back = fitted({{2, -0.1}, {0, -0.1}});
  const BorderPoint behind{{1, -0.1}, {0, kAcross}, true};
  EXPECT_EQ(misfit_of(wall, behind), kLineParams.behind_share);
  EXPECT_EQ(misfits({wall, back}, behind, half_known_room(), kLineParams),
            (std::vector<double>{1.0, 0.0}));
}

}  // namespace
}  // namespace echomap::mapping
