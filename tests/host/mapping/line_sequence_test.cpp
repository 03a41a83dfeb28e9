// SPDX-License-Identifier: MIT
#include "host/mapping/line_sequence.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace echomap::mapping {
namespace {

using Misfits = std::vector<std::vector<double>>;

const LineSequenceParams kSequenceParams;
const RasterMap kUnknownMap(100, 100, 0.05, {-2.5, -2.5});

/// The four sides of a room of 1 x 1 m, counter-clockwise.
std::vector<OutlineLine> sides() {
  std::vector<OutlineLine> lines;
  for (const auto& [point_m, direction] :
       {std::pair<Eigen::Vector2d, Eigen::Vector2d>{{0, 0}, {1, 0}},
        {{1, 0}, {0, 1}},
        {{1, 1}, {-1, 0}},
        {{0, 1}, {0, -1}}}) {
    lines.push_back({{point_m, direction}, {{point_m, point_m + direction}}, true, true, 0.0});
  }
  return lines;
}

/// Twenty points on each side, from the middle of the first one on.
std::vector<BorderPoint> room_border() {
  std::vector<BorderPoint> border;
  for (int i = 0; i < 80; ++i) {
    const int at = (i + 10) % 80;
    const OutlineLine line = sides()[static_cast<std::size_t>(at / 20)];
    border.push_back({line.line.point_m + (0.05 * (at % 20) + 0.025) * line.line.direction,
                      Eigen::Vector2d::Zero(),
                      true});
  }
  return border;
}

Misfits by_distance(const std::vector<BorderPoint>& border, const std::vector<OutlineLine>& lines) {
  Misfits misfits;
  for (const BorderPoint& point : border) {
    std::vector<double> shares;
    for (const OutlineLine& line : lines) {
      shares.push_back(std::min(1.0, std::pow(line.line.left_m(point.position_m) / 0.15, 2)));
    }
    misfits.push_back(shares);
  }
  return misfits;
}

TEST(LineSequence, FindsTheSidesOfARoomInTheirOrder) {
  const auto border = room_border();
  const auto runs =
      line_sequence(border, sides(), by_distance(border, sides()), kUnknownMap, kSequenceParams);
  ASSERT_EQ(runs.size(), 4U);
  std::size_t covered = 0;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    EXPECT_EQ(runs[i].line, (i + 1) % 4);
    EXPECT_NEAR(static_cast<double>(runs[i].end - runs[i].begin), 20.0, 2.0);
    EXPECT_EQ(runs[i].end % 80, runs[(i + 1) % 4].begin);
    covered += runs[i].end - runs[i].begin;
  }
  EXPECT_EQ(covered, 80U);
}

/// How many sides there are if there is a line for a step of the first side, this many points long
/// and 30 cm deep.
std::size_t sides_with_step(std::size_t points) {
  auto lines = sides();
  lines.push_back({{{0, 0.3}, {1, 0}}, {{{0, 0.3}, {1, 0.3}}}, true, true, 0.0});
  auto border = room_border();
  LineSequenceParams params;
  params.corner_cost_m = 0.05;
  for (std::size_t i = 0; i < points; ++i) {
    border[(76 + i) % 80].position_m.y() = 0.3;
  }
  return line_sequence(border, lines, by_distance(border, lines), kUnknownMap, params).size();
}

TEST(LineSequence, HasACornerOnlyWhereItPaysForItself) {
  EXPECT_EQ(sides_with_step(2), 4U);
  EXPECT_EQ(sides_with_step(8), 6U) << "the first side twice, and the step";
}

TEST(LineSequence, OfNothingOrOneLineHasNoRuns) {
  const auto border = room_border();
  EXPECT_TRUE(line_sequence({}, sides(), {}, kUnknownMap, kSequenceParams).empty());
  EXPECT_TRUE(line_sequence(border, {}, Misfits(80), kUnknownMap, kSequenceParams).empty());
  const std::vector<OutlineLine> one{sides().front()};
  EXPECT_TRUE(
      line_sequence(border, one, by_distance(border, one), kUnknownMap, kSequenceParams).empty());
}

using Lines = std::vector<std::size_t>;

/// What a ring with these lines by point costs, if every change of line is a step.
double cost_m(const Lines& line_at,
              const Misfits& misfits,
              const std::vector<OutlineLine>& lines,
              const LineSequenceParams& params) {
  double sum_m = 0.0;
  for (std::size_t i = 0; i < line_at.size(); ++i) {
    const bool turns = line_at[i] != line_at[(i + line_at.size() - 1) % line_at.size()];
    sum_m += kUnknownMap.resolution_m() * misfits[i][line_at[i]] +
             (turns ? 2.0 * params.corner_cost_m + lines[line_at[i]].cost_m : 0.0);
  }
  return sum_m;
}

TEST(LineSequence, CostsNoMoreThanAnyOtherOne) {
  constexpr std::size_t kPoints = 10;
  std::mt19937 random(5);
  std::uniform_real_distribution<double> share(0.0, 0.99);
  auto border = room_border();
  border.resize(kPoints);
  std::vector<OutlineLine> parallel{sides()[0], sides()[2]};
  parallel[0].cost_m = 0.004;
  parallel[1].cost_m = 0.002;
  LineSequenceParams params;
  params.corner_cost_m = 0.005;
  for (int trial = 0; trial < 100; ++trial) {
    Misfits misfits;
    for (std::size_t i = 0; i < kPoints; ++i) {
      misfits.push_back({share(random), share(random)});
    }
    double min_m = std::numeric_limits<double>::infinity();
    for (std::size_t code = 0; code < 1U << kPoints; ++code) {
      Lines line_at;
      for (std::size_t i = 0; i < kPoints; ++i) {
        line_at.push_back(code >> i & 1U);
      }
      min_m = std::min(min_m, cost_m(line_at, misfits, parallel, params));
    }
    const auto runs = line_sequence(border, parallel, misfits, kUnknownMap, params);
    Lines found(kPoints);
    for (const LineRun& run : runs) {
      for (std::size_t i = run.begin; i < run.end; ++i) {
        found[i % kPoints] = run.line;
      }
    }
    double found_m = cost_m(found, misfits, parallel, params);
    if (runs.empty()) {
      found_m = std::min(found_m, cost_m(Lines(kPoints, 1), misfits, parallel, params));
    }
    EXPECT_NEAR(found_m, min_m, 1e-9) << trial;
  }
}

TEST(LineCorner, IsWhereTheLinesCrossIfThatIsNear) {
  const DirectedLine east{{0, 0}, {1, 0}};
  const DirectedLine north{{1, 0}, {0, 1}};
  const auto corner = line_corner(east, north, {0.9, 0.0}, kUnknownMap, kSequenceParams);
  ASSERT_TRUE(corner);
  EXPECT_LT((corner->position_m - Eigen::Vector2d(1, 0)).norm(), 1e-9);
  EXPECT_NEAR(corner->cost_m, kSequenceParams.corner_cost_m * 1.04, 1e-9);
  EXPECT_FALSE(line_corner(east, north, {0.4, 0.0}, kUnknownMap, kSequenceParams)) << "far";
  EXPECT_FALSE(line_corner(east, {{0, 0.1}, {1, 0.1}}, {0.0, 0.0}, kUnknownMap, kSequenceParams))
      << "hardly a turn";
}

TEST(LineCorner, MustBeNearerOnTheFloor) {
  RasterMap floor = kUnknownMap;
  floor.set(floor.cell_at({1, 0}), CellState::kFree);
  const DirectedLine east{{0, 0}, {1, 0}};
  const DirectedLine north{{1, 0}, {0, 1}};
  EXPECT_TRUE(line_corner(east, north, {0.7, 0.0}, kUnknownMap, kSequenceParams));
  EXPECT_FALSE(line_corner(east, north, {0.7, 0.0}, floor, kSequenceParams));
  EXPECT_TRUE(line_corner(east, north, {0.9, 0.0}, floor, kSequenceParams));
}

}  // namespace
}  // namespace echomap::mapping
