// SPDX-License-Identifier: MIT
#include "host/mapping/line_extraction.hpp"

#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

#include "host/geometry/polygon.hpp"
#include "host/geometry/pose2.hpp"
#include "tests/host/mapping/outlines.hpp"

namespace echomap::mapping {
namespace {

using geometry::Polygon;
using Points = std::vector<Eigen::Vector2d>;

/// What stands along the sides of a room every 5 cm, counter-clockwise, with noise.
Points along(const Polygon& room, double stddev_m, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> noise_m(0.0, stddev_m);
  Points points;
  for (std::size_t i = 0; i < room.size(); ++i) {
    const auto [from, to] = geometry::side(room, i);
    const int steps = static_cast<int>(std::lround((to - from).norm() / 0.05));
    for (int step = 0; step < steps; ++step) {
      points.emplace_back(from + (step + 0.5) / steps * (to - from) +
                          Eigen::Vector2d(noise_m(random), noise_m(random)));
    }
  }
  return points;
}

TEST(LineExtraction, FindsEveryWallOfARoom) {
  for (std::uint32_t seed = 1; seed <= 50; ++seed) {
    const auto lines = extract_lines(along(kL, 0.01, seed));
    ASSERT_EQ(lines.size(), 6U) << seed;
    for (std::size_t i = 0; i < 6; ++i) {
      const auto wall = geometry::side(kL, i);
      EXPECT_LT(geometry::distance_m(wall, lines[i].segment.from_m), 0.04) << seed << " " << i;
      EXPECT_LT(geometry::distance_m(wall, lines[i].segment.to_m), 0.04) << seed << " " << i;
      EXPECT_GT(lines[i].segment.length_m(), 0.8 * wall.length_m()) << seed << " " << i;
    }
  }
}

TEST(LineExtraction, LeavesAGapWhereADoorIs) {
  Points points;
  for (int i = 0; i <= 40; ++i) {
    if (i < 15 || i > 30) {
      points.emplace_back(0.1 * i, 1.0);
    }
  }
  const auto lines = extract_lines(points);
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_NEAR(lines[0].segment.to_m.x(), 1.4, 1e-9);
  EXPECT_NEAR(lines[1].segment.from_m.x(), 3.1, 1e-9);
}

TEST(LineExtraction, JoinsAWallThatAnOutlierSplits) {
  Points points;
  for (int i = 0; i <= 40; ++i) {
    points.emplace_back(0.05 * i, 0.02 * (i % 2));
  }
  EXPECT_EQ(extract_lines(points).size(), 1U);
}

TEST(LineExtraction, DropsClutter) {
  EXPECT_TRUE(extract_lines({}).empty());
  EXPECT_TRUE(extract_lines({{0, 0}}).empty());
  EXPECT_TRUE(extract_lines({{0, 0}, {0.05, 0}, {0.1, 0}, {0.15, 0}}).empty()) << "four points";
  EXPECT_TRUE(extract_lines(Points(9, Eigen::Vector2d(1, 1))).empty()) << "one place";
}

TEST(LineExtraction, TurnsAndMovesWithItsPoints) {
  const Points points = along(kL, 0.01, 3);
  const auto lines = extract_lines(points);
  std::mt19937 random(4);
  std::uniform_real_distribution<double> any(-3.0, 3.0);
  for (int trial = 0; trial < 50; ++trial) {
    const geometry::Pose2 T_new_old(any(random), any(random), any(random));
    Points moved;
    for (const auto& point : points) {
      moved.push_back(T_new_old * point);
    }
    const auto others = extract_lines(moved);
    ASSERT_EQ(others.size(), lines.size()) << trial;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      EXPECT_LT((T_new_old * lines[i].segment.from_m - others[i].segment.from_m).norm(), 1e-8);
    }
  }
}

TEST(LineExtraction, ChecksItsParameters) {
  LineExtractionParams params;
  params.min_points = 1;
  EXPECT_THROW(extract_lines({}, params), std::invalid_argument);
  params = {};
  params.split_distance_m = 0.0;
  EXPECT_THROW(extract_lines({}, params), std::invalid_argument);
}

TEST(WallCorners, AreTheRoomsWithTheirKinds) {
  for (std::uint32_t seed = 1; seed <= 50; ++seed) {
    const auto corners = find_corners(extract_lines(along(kL, 0.01, seed)), true);
    ASSERT_EQ(corners.size(), 6U) << seed;
    for (const auto& corner : corners) {
      const std::size_t index = (corner.line + 1) % 6;
      EXPECT_LT((corner.position_m - kL[index]).norm(), 0.05) << seed << " " << index;
      EXPECT_EQ(corner.kind, corner_kind(kL, index)) << seed << " " << index;
    }
  }
}

TEST(WallCorners, AreNoneWhereWallsEndFarApartOrGoOn) {
  const auto far_apart = extract_lines({{0, 0},
                                        {0.1, 0},
                                        {0.2, 0},
                                        {0.3, 0},
                                        {0.4, 0},
                                        {1, 1},
                                        {1, 1.1},
                                        {1, 1.2},
                                        {1, 1.3},
                                        {1, 1.4}});
  ASSERT_EQ(far_apart.size(), 2U);
  EXPECT_TRUE(find_corners(far_apart, false).empty());
  EXPECT_TRUE(find_corners({}, true).empty());
  EXPECT_TRUE(find_corners({far_apart[0]}, true).empty());
  EXPECT_TRUE(find_corners({far_apart[0], far_apart[0]}, false).empty());
}

}  // namespace
}  // namespace echomap::mapping
