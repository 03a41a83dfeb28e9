// SPDX-License-Identifier: MIT
#include "host/mapping/sonar_cone_mapper.hpp"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"

namespace echomap::mapping {
namespace {

using geometry::radians;

PlacedReading reading(double x_m, double y_m, double degrees, std::optional<double> range_m) {
  return {{x_m, y_m, 0.0}, {x_m, y_m, radians(degrees)}, range_m};
}

SonarConeMap map_of(const Scan& readings) {
  SonarConeMapper mapper;
  mapper.add(readings);
  return mapper.map();
}

CellState state_at(const SonarConeMap& map, double x_m, double y_m) {
  return map.grid.state(map.grid.cell_at({x_m, y_m}));
}

/// A drive along y = 0 beside a smooth wall along y = 1, with a sonar that sweeps its left side.
Scan drive_beside_wall() {
  Scan readings;
  for (double x_m = 0.0; x_m < 3.0; x_m += 0.6) {
    for (int degree = 0; degree <= 180; degree += 10) {
      const bool hears = std::abs(degree - 90) <= 15;
      readings.push_back(reading(x_m, 0.0, degree, hears ? std::optional(1.0) : std::nullopt));
    }
  }
  return readings;
}

TEST(SonarConeMapper, KnowsNothingWithoutReadings) {
  EXPECT_TRUE(map_of({}).grid.bounds().empty());
}

TEST(SonarConeMapper, LeavesTheUnseenUnknown) {
  const auto map = map_of({reading(0.0, 0.0, 0.0, 1.0)});
  EXPECT_EQ(state_at(map, 0.5, 0.0), CellState::kFree);
  EXPECT_EQ(state_at(map, 1.3, 0.0), CellState::kUnknown);
  EXPECT_EQ(state_at(map, 0.5, 0.5), CellState::kUnknown);
  EXPECT_EQ(state_at(map, -0.5, 0.0), CellState::kUnknown);
}

TEST(SonarConeMapper, DoesNotDrawTheArcOfASingleWideEcho) {
  const auto map = map_of({reading(0.0, 0.0, 0.0, 2.0)});
  for (double degree = -15.0; degree <= 15.0; degree += 1.0) {
    EXPECT_NE(state_at(map, 2.0 * std::cos(radians(degree)), 2.0 * std::sin(radians(degree))),
              CellState::kOccupied);
  }
}

TEST(SonarConeMapper, CarvesArcsDownToThePostThatAllHear) {
  Scan readings;
  for (int degree = -40; degree <= 40; degree += 5) {
    const bool hears = std::abs(degree) <= 15;
    readings.push_back(reading(0.0, 0.0, degree, hears ? std::optional(1.025) : 2.0));
  }
  for (const double y_m : {-1.0, 1.0}) {
    const double to_post = geometry::degrees(std::atan2(0.025 - y_m, 1.025));
    for (int degree = -40; degree <= 40; degree += 5) {
      const bool hears = std::abs(degree) <= 15;
      readings.push_back(
          reading(0.0, y_m, to_post + degree, hears ? std::hypot(1.025, 0.025 - y_m) : 2.0));
    }
  }
  const auto map = map_of(readings);
  EXPECT_EQ(state_at(map, 1.025, 0.025), CellState::kOccupied);
  EXPECT_NE(state_at(map, 1.0, 0.22), CellState::kOccupied);
  EXPECT_NE(state_at(map, 1.0, -0.22), CellState::kOccupied);
}

TEST(SonarConeMapper, ClosesASmoothWallThatMostReadingsMiss) {
  const auto map = map_of(drive_beside_wall());
  EXPECT_GE(map.wall_pieces, 4U);
  for (double x_m = 0.05; x_m < 2.4; x_m += 0.1) {
    EXPECT_NE(state_at(map, x_m, 1.01), CellState::kFree) << x_m;
    EXPECT_NE(state_at(map, x_m, 1.3), CellState::kFree) << x_m;
    EXPECT_EQ(state_at(map, x_m, 0.5), CellState::kFree) << x_m;
  }
  for (double x_m = 0.65; x_m < 1.8; x_m += 0.1) {
    EXPECT_EQ(state_at(map, x_m, 1.01), CellState::kOccupied) << x_m;
  }
}

TEST(SonarConeMapper, SeeksNoSmoothWallsByLight) {
  SonarConeMapperParams params;
  params.is_sound = false;
  SonarConeMapper mapper(params);
  mapper.add(drive_beside_wall());
  EXPECT_EQ(mapper.map().wall_pieces, 0U);
}

TEST(SonarConeMapper, CountsAnEchoFromBehindAWallAsAGhost) {
  Scan readings = drive_beside_wall();
  readings.push_back(reading(1.5, 0.3, 60.0, 1.9));
  const auto map = map_of(readings);
  EXPECT_EQ(map.counts.behind_wall, 1U);
  EXPECT_NE(state_at(map, 2.45, 1.95), CellState::kOccupied);
}

TEST(SonarConeMapper, CountsAnEchoThatOthersSeeThroughAsAGhost) {
  Scan readings{reading(0.0, 0.0, 0.0, 1.0)};
  for (const double y_m : {-0.5, -0.25, 0.25, 0.5}) {
    for (int degree = -30; degree <= 30; degree += 10) {
      readings.push_back(reading(0.05, y_m, degree, 2.5));
    }
  }
  const auto map = map_of(readings);
  EXPECT_GE(map.counts.seen_through, 1U);
  EXPECT_EQ(state_at(map, 1.0, 0.0), CellState::kFree);
}

TEST(SonarConeMapper, AccountsForEveryReading) {
  const auto counts = map_of(drive_beside_wall()).counts;
  EXPECT_EQ(counts.readings, 95U);
  EXPECT_EQ(counts.silent, 80U);
  EXPECT_EQ(counts.used_echoes(), 15U);
}

TEST(SonarConeMapper, RefusesWhatNoMemoryWouldHold) {
  SonarConeMapper mapper;
  mapper.add({reading(0.0, 0.0, 0.0, 1.0), reading(1e7, 1e7, 0.0, 1.0)});
  EXPECT_THROW(mapper.map(), std::length_error);
}

TEST(SonarConeMapper, RefusesParametersWithoutSense) {
  SonarConeMapperParams params;
  params.rounds = 0;
  EXPECT_THROW(SonarConeMapper{params}, std::invalid_argument);
}

}  // namespace
}  // namespace echomap::mapping
