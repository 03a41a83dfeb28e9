// SPDX-License-Identifier: MIT
#include "host/sensors/wall_beam_width.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"
#include "host/sensors/range_scan.hpp"

namespace echomap::sensors {
namespace {

using geometry::radians;

/// A wall as a cone hears it up to 45 degrees off its perpendicular.
struct HeardWall {
  double bearing_deg;
  double range_m;
};

std::optional<double> nearest_m(const std::vector<HeardWall>& walls,
                                double bearing_rad,
                                double half_rad) {
  std::optional<double> nearest;
  for (const HeardWall& wall : walls) {
    const double off_rad = std::max(
        0.0, std::abs(geometry::angle_between(radians(wall.bearing_deg), bearing_rad)) - half_rad);
    if (off_rad < radians(45.0)) {
      nearest = std::min(nearest.value_or(9.0), wall.range_m / std::cos(off_rad));
    }
  }
  return nearest;
}

/// All round from `first_deg`, steps of 5 degrees, in whole centimetres as the NXT's sonar counts.
std::vector<Beam> sweep_past(const std::vector<HeardWall>& walls,
                             double beam_width_deg,
                             double first_deg = 0.0) {
  std::vector<Beam> sweep;
  for (int i = 0; i < 72; ++i) {
    const double bearing_rad = geometry::wrap_angle(radians(first_deg + 5.0 * i));
    auto range_m = nearest_m(walls, bearing_rad, radians(0.5 * beam_width_deg));
    if (range_m) {
      range_m = 0.01 * std::round(100.0 * *range_m);
    }
    sweep.push_back({bearing_rad, range_m});
  }
  return sweep;
}

TEST(SweptWalls, FindsTheOpeningOfTheCone) {
  for (const double beam_width_deg : {15.0, 32.8, 45.0}) {
    const auto walls = swept_walls(sweep_past({{90.0, 0.6}}, beam_width_deg));
    ASSERT_EQ(walls.size(), 1U) << beam_width_deg;
    EXPECT_NEAR(geometry::degrees(walls[0].beam_width.beam_width_rad), beam_width_deg, 4.0);
    EXPECT_LE(walls[0].beam_width.low_rad, radians(beam_width_deg));
    EXPECT_GE(walls[0].beam_width.high_rad, radians(beam_width_deg));
    EXPECT_NEAR(geometry::degrees(walls[0].bearing_rad), 90.0, 2.0);
    EXPECT_NEAR(walls[0].range_m, 0.6, 0.01);
  }
}

TEST(SweptWalls, TellsWallsOfOneCornerApart) {
  const auto walls = swept_walls(sweep_past({{0.0, 0.3}, {90.0, 0.35}, {200.0, 0.8}}, 30.0));
  ASSERT_EQ(walls.size(), 3U);
  EXPECT_NEAR(walls[0].range_m, 0.8, 0.01);
  EXPECT_NEAR(walls[1].range_m, 0.3, 0.01);
  EXPECT_NEAR(walls[2].range_m, 0.35, 0.01);
}

TEST(SweptWalls, IsTheSameWhereverTheSweepBeginsAndWhicheverWayItGoes) {
  const std::vector<HeardWall> room = {{0.0, 0.5}};
  auto ring = sweep_past(room, 30.0);
  const auto begun_behind = swept_walls(sweep_past(room, 30.0, 180.0));
  const auto begun_amidst = swept_walls(ring);
  std::reverse(ring.begin(), ring.end());
  const auto turned_back = swept_walls(ring);
  ASSERT_EQ(begun_behind.size(), 1U);
  ASSERT_EQ(begun_amidst.size(), 1U);
  ASSERT_EQ(turned_back.size(), 1U);
  EXPECT_EQ(begun_amidst[0].readings, begun_behind[0].readings);
  EXPECT_NEAR(
      begun_amidst[0].beam_width.beam_width_rad, begun_behind[0].beam_width.beam_width_rad, 1e-9);
  EXPECT_NEAR(
      turned_back[0].beam_width.beam_width_rad, begun_behind[0].beam_width.beam_width_rad, 1e-9);
}

TEST(SweptWalls, PassesOverWhatIsNoWall) {
  std::vector<Beam> ragged;
  for (int i = 0; i < 72; ++i) {
    ragged.push_back({radians(5.0 * i), i % 2 == 0 ? 0.50 : 0.53});
  }
  EXPECT_TRUE(swept_walls(ragged).empty());
  EXPECT_TRUE(swept_walls({}).empty());
  EXPECT_TRUE(swept_walls(std::vector<Beam>(72)).empty());
}

TEST(SweptWalls, RefusesParametersWithoutSense) {
  EXPECT_THROW(swept_walls({}, {0.0, 0.05, 8}), std::invalid_argument);
  EXPECT_THROW(swept_walls({}, {0.005, 0.05, 3}), std::invalid_argument);
}

TEST(PooledBeamWidth, IsTheMeanWithStudentsBounds) {
  std::vector<SweptWall> walls(3);
  walls[0].beam_width.beam_width_rad = 0.4;
  walls[1].beam_width.beam_width_rad = 0.5;
  walls[2].beam_width.beam_width_rad = 0.6;
  const auto pooled = pooled_beam_width(walls);
  ASSERT_TRUE(pooled);
  EXPECT_NEAR(pooled->mean.beam_width_rad, 0.5, 1e-12);
  EXPECT_NEAR(pooled->spread_rad, 0.1, 1e-12);
  EXPECT_NEAR(pooled->mean.high_rad, 0.5 + 4.303 * 0.1 / std::sqrt(3.0), 1e-3);
  walls.pop_back();
  EXPECT_FALSE(pooled_beam_width(walls));
}

}  // namespace
}  // namespace echomap::sensors
