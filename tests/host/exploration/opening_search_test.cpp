// SPDX-License-Identifier: MIT
#include "host/exploration/opening_search.hpp"

#include <algorithm>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"
#include "tests/support/drawn_map.hpp"

namespace echomap::exploration {
namespace {

using geometry::Pose2;
using geometry::radians;
using mapping::CellState;
using mapping::RasterMap;

const OpeningParams kParams;

/// A corridor of 1 m along x that is known for 1.5 m; 1 m beyond it lies unknown.
RasterMap corridor() {
  RasterMap map(50, 22, 0.05, {0.0, 0.0});
  for (int x = 0; x < 30; ++x) {
    for (int y = 0; y < 22; ++y) {
      map.set({x, y}, y == 0 || y == 21 ? CellState::kOccupied : CellState::kFree);
    }
  }
  return map;
}

/// A stop in the corridor: readings all round, 4 degrees apart, each as `range` of its bearing.
template <typename Range>
std::vector<mapping::Scan> stop_at(double x_m, double y_m, Range range) {
  mapping::Scan scan;
  for (int deg = -180; deg < 180; deg += 4) {
    const Pose2 at(x_m, y_m, radians(deg));
    scan.push_back({at, at, range(radians(deg))});
  }
  return {scan};
}

std::optional<double> silence(double) { return std::nullopt; }

TEST(Openings, LieWhereABeamAlongTheCorridorWasNotAnswered) {
  const auto openings = find_openings(corridor(), stop_at(0.8, 0.55, silence), kParams);
  ASSERT_FALSE(openings.empty());
  for (const Opening& opening : openings) {
    EXPECT_NEAR(opening.edge_m.x(), 1.475, 1e-9);
    EXPECT_GT(opening.beyond_m.x(), 1.5 + kParams.step_m - 0.05);
    EXPECT_LT(opening.beyond_m.x(), 1.5 + kParams.step_m + 0.1);
    EXPECT_GT(opening.beyond_m.y(), 0.025 + kParams.half_width_m);
    EXPECT_LT(opening.beyond_m.y(), 1.075 - kParams.half_width_m);
  }
}

TEST(Openings, AreNoneWhereTheEndOfTheCorridorAnswers) {
  const auto wall = [](double bearing_rad) {
    return std::abs(bearing_rad) < radians(13.0) ? std::optional(0.75) : std::nullopt;
  };
  EXPECT_TRUE(find_openings(corridor(), stop_at(0.8, 0.55, wall), kParams).empty());
}

TEST(Openings, AreThereWhereTheAnswerCameFromFarBehindTheEdge) {
  const auto far_wall = [](double bearing_rad) {
    return std::abs(bearing_rad) < radians(13.0) ? std::optional(1.6) : std::nullopt;
  };
  EXPECT_FALSE(find_openings(corridor(), stop_at(0.8, 0.55, far_wall), kParams).empty());
}

TEST(Openings, AreNotToldFromAfar) {
  OpeningParams near = kParams;
  near.far_m = 0.5;
  EXPECT_TRUE(find_openings(corridor(), stop_at(0.8, 0.55, silence), near).empty());
}

/// The corridor with one side of it unknown.
RasterMap corridor_without_a_side() {
  RasterMap map(50, 40, 0.05, {0.0, 0.0});
  for (int x = 0; x < 30; ++x) {
    for (int y = 0; y < 21; ++y) {
      map.set({x, y}, y == 0 ? CellState::kOccupied : CellState::kFree);
    }
  }
  return map;
}

TEST(Openings, AreNotToldFromSilenceAtASlant) {
  const auto x_of_side_openings_m = [](const OpeningParams& params) {
    std::vector<double> found_m;
    const auto scans = stop_at(0.3, 0.3, silence);
    for (const Opening& opening : find_openings(corridor_without_a_side(), scans, params)) {
      if (opening.beyond_m.x() < 1.5) {
        found_m.push_back(opening.beyond_m.x());
      }
    }
    return found_m;
  };
  const auto square_m = x_of_side_openings_m(kParams);
  ASSERT_FALSE(square_m.empty()) << "across from the stop";
  EXPECT_LT(*std::max_element(square_m.begin(), square_m.end()), 0.6)
      << "the wall along the corridor would have thrown the sound aside";
  OpeningParams any = kParams;
  any.square_rad = 1.4;
  const auto any_m = x_of_side_openings_m(any);
  ASSERT_FALSE(any_m.empty());
  EXPECT_GT(*std::max_element(any_m.begin(), any_m.end()), 0.9);
}

TEST(Openings, AreNotSeenThroughAWall) {
  RasterMap map = corridor();
  for (int y = 0; y < 22; ++y) {
    map.set({20, y}, CellState::kOccupied);
  }
  EXPECT_TRUE(find_openings(map, stop_at(0.8, 0.55, silence), kParams).empty());
}

TEST(Openings, AreAsWideAsADoorAtLeast) {
  RasterMap map = corridor();
  for (int y = 0; y < 22; ++y) {
    if (y < 7 || y > 14) {
      map.set({30, y}, CellState::kOccupied);
    }
  }
  EXPECT_TRUE(find_openings(map, stop_at(0.8, 0.55, silence), kParams).empty());
  OpeningParams narrow = kParams;
  narrow.half_width_m = 0.15;
  EXPECT_FALSE(find_openings(map, stop_at(0.8, 0.55, silence), narrow).empty());
}

TEST(Openings, AreNoneWithoutAnyScan) {
  EXPECT_TRUE(find_openings(corridor(), {}, kParams).empty());
  EXPECT_TRUE(find_openings(corridor(), {mapping::Scan{}}, kParams).empty());
}

}  // namespace
}  // namespace echomap::exploration
