// SPDX-License-Identifier: MIT
#include "host/exploration/view_gain.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"

namespace echomap::exploration {
namespace {

using geometry::radians;
using mapping::CellState;
using mapping::RasterMap;

constexpr double kMapCellM = 0.05;

/// 3 m x 3 m of free floor in the middle of 5 m x 5 m, with a wall to the left of it.
RasterMap open_to_the_right() {
  RasterMap map(100, 100, kMapCellM, {-2.5, -2.5});
  for (int y = 20; y < 80; ++y) {
    for (int x = 20; x < 80; ++x) {
      map.set({x, y}, CellState::kFree);
    }
  }
  for (int y = 0; y < 100; ++y) {
    map.set({19, y}, CellState::kOccupied);
  }
  return map;
}

ViewGainParams plain() {
  ViewGainParams params;
  params.reach_m = 4.0;
  params.fade_m = 1e6;
  params.look_fade_m = 1e6;
  params.depth_m = 0.5;
  params.beside_wall_m = 0.0;
  return params;
}

double sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

/// A scan of (1, 2) over the bearings from one to the other, 4 degrees apart.
mapping::Scan scan_over(int from_deg, int to_deg) {
  mapping::Scan scan;
  for (int deg = from_deg; deg <= to_deg; deg += 4) {
    const geometry::Pose2 at(1.0, 2.0, radians(deg));
    scan.push_back({at, at, std::nullopt});
  }
  return scan;
}

TEST(ViewsOf, AreWhatEachScanHasLookedAt) {
  const auto views = views_of({scan_over(-180, 179), {}, scan_over(120, 240)});
  ASSERT_EQ(views.size(), 2U) << "a scan without a reading is none";
  EXPECT_NEAR((views[0].from_m - Eigen::Vector2d(1.0, 2.0)).norm(), 0.0, 1e-9);
  EXPECT_DOUBLE_EQ(views[0].half_width_rad, std::numbers::pi);
  EXPECT_NEAR(std::abs(views[1].middle_rad), std::numbers::pi, 1e-9);
  EXPECT_NEAR(views[1].half_width_rad, radians(60.0), 1e-9);
}

TEST(ViewGain, IsTheAreaOfTheUnknownFloorInSightUpToItsDepth) {
  const RasterMap map = open_to_the_right();
  const auto gain_m2 = ViewGain(map, {}, {}, plain()).by_sector_m2({0.0, 0.0});
  for (std::size_t i = 0; i < gain_m2.size(); ++i) {
    const double bearing_rad =
        -std::numbers::pi + (static_cast<double>(i) + 0.5) * 2.0 * std::numbers::pi / 72.0;
    const double to_border_m =
        1.5 / std::max(std::abs(std::cos(bearing_rad)), std::abs(std::sin(bearing_rad)));
    const bool wall = std::cos(bearing_rad) < -std::abs(std::sin(bearing_rad));
    const double to_m = to_border_m + 0.5;
    if (std::abs(std::abs(bearing_rad) - 0.75 * std::numbers::pi) < radians(5.0)) {
      continue;  // Half of the sector looks at the wall.
    }
    const double wedge_m2 =
        0.5 * (to_m * to_m - to_border_m * to_border_m) * 2.0 * std::numbers::pi / 72.0;
    EXPECT_NEAR(gain_m2[i], wall ? 0.0 : wedge_m2, 0.15 * wedge_m2) << "sector " << i;
  }
}

TEST(ViewGain, WhatWasLookedAtInVainCountsLessEachTime) {
  const RasterMap map = open_to_the_right();
  auto params = plain();
  params.novel_m = 0.01;
  const Eigen::Vector2d beside_m(params.novel_m, 0.0);
  const PastView rightwards{{0.0, 0.0}, 0.0, radians(45.0)};
  const double fresh_m2 = sum(ViewGain(map, {}, {}, params).by_sector_m2(beside_m));
  const double once_m2 = sum(ViewGain(map, {rightwards}, {}, params).by_sector_m2(beside_m));
  const double twice_m2 =
      sum(ViewGain(map, {rightwards, rightwards}, {}, params).by_sector_m2(beside_m));
  EXPECT_NEAR(once_m2, fresh_m2 / 3.0 * (2.0 + params.left_by_look), 0.05 * fresh_m2);
  EXPECT_NEAR(twice_m2,
              fresh_m2 / 3.0 * (2.0 + params.left_by_look * params.left_by_look),
              0.05 * fresh_m2);
}

/// An unknown square of 1 m in the middle of the floor, with so many of its four sides occupied.
RasterMap with_island(int sides) {
  RasterMap map(100, 100, kMapCellM, {-2.5, -2.5});
  for (int y = 5; y < 95; ++y) {
    for (int x = 5; x < 95; ++x) {
      map.set({x, y},
              std::max(std::abs(x - 50), std::abs(y - 50)) <= 10 ? CellState::kUnknown
                                                                 : CellState::kFree);
    }
  }
  for (int i = -10; i <= 10; ++i) {
    const geometry::CellIndex rim[] = {{39, 50 + i}, {61, 50 + i}, {50 + i, 39}, {50 + i, 61}};
    for (int side = 0; side < sides; ++side) {
      map.set(rim[side], CellState::kOccupied);
    }
  }
  return map;
}

TEST(ViewGain, OfAnIslandALookCountsByItsOccupiedRim) {
  const PastView once{{2.0, 0.0}, std::numbers::pi, radians(45.0)};
  const geometry::CellIndex seen{60, 50};
  const auto gain_on = [&](const RasterMap& map) { return ViewGain(map, {once}, {}, plain()); };
  const auto params = plain();
  const RasterMap no_side = with_island(0);
  EXPECT_NEAR(
      gain_on(no_side).worth(seen), std::pow(params.left_by_look, params.min_island_look), 1e-5);
  RasterMap one_side = with_island(1);
  EXPECT_NEAR(gain_on(one_side).worth(seen), std::pow(params.left_by_look, 0.25), 1e-5);
  for (int x = 0; x < 40; ++x) {
    one_side.set({x, 50}, CellState::kUnknown);
  }
  EXPECT_NEAR(gain_on(one_side).worth(seen), params.left_by_look, 1e-5)
      << "it reaches the edge of the map";
}

TEST(ViewGain, AnIslandIsExpectedToBeFloorByItsOpenRimHoweverOftenItWasLookedAt) {
  const PastView view{{2.0, 0.0}, std::numbers::pi, radians(45.0)};
  const std::vector<PastView> often(100, view);
  const geometry::CellIndex seen{60, 50};
  for (const int sides : {0, 1}) {
    const RasterMap map = with_island(sides);
    const ViewGain gain(map, often, {}, plain());
    EXPECT_LT(gain.worth(seen), 0.01);
    EXPECT_NEAR(gain.floor_share(seen), (1.0 - 0.25 * sides) * plain().island_floor, 0.01) << sides;
  }
}

TEST(ViewGain, FromBesideAnEarlierStopLessIsNew) {
  const RasterMap map = open_to_the_right();
  const auto params = plain();
  const PastView behind{{0.0, 0.0}, std::numbers::pi, radians(10.0)};
  const ViewGain fresh(map, {}, {}, params);
  const ViewGain gain(map, {behind}, {}, params);
  EXPECT_EQ(sum(gain.by_sector_m2({0.0, 0.0})), 0.0);
  for (const double off_m : {0.1, 0.3, 0.5, 1.0}) {
    const double fresh_m2 = sum(fresh.by_sector_m2({off_m, 0.0}));
    EXPECT_NEAR(sum(gain.by_sector_m2({off_m, 0.0})),
                std::min(1.0, off_m / params.novel_m) * fresh_m2,
                1e-9)
        << off_m;
  }
}

TEST(ViewGain, BehindAWallThatNobodyHasHeardFloorIsExpectedUntilAStopHasFacedIt) {
  const RasterMap map = open_to_the_right();
  const auto params = plain();
  const std::vector<geometry::Segment> unobserved{{{-1.5, 0.5}, {-1.5, -0.5}}};
  const PastView facing{{-0.5, 0.0}, std::numbers::pi, radians(45.0)};
  const PastView oblique{{-0.5, 1.2}, std::numbers::pi, radians(90.0)};
  const Eigen::Vector2d before_m(-0.5, -0.3);
  const auto expected_m2 = [&](const std::vector<PastView>& past) {
    auto near = params;
    near.novel_m = 0.1;
    return sum(ViewGain(map, past, unobserved, near).by_sector_m2(before_m)) -
           sum(ViewGain(map, past, {}, near).by_sector_m2(before_m));
  };
  const double fresh_m2 = params.unobserved.floor_chance * params.depth_m * 1.0;
  EXPECT_NEAR(expected_m2({}), fresh_m2, 1e-9);
  EXPECT_NEAR(expected_m2({oblique}), fresh_m2, 1e-9);
  EXPECT_NEAR(expected_m2({facing}), fresh_m2 * params.left_by_look, 1e-9);
}

TEST(ViewGain, WhatSomebodyElseIsAboutToSeeIsLeftToThem) {
  const RasterMap map = open_to_the_right();
  ViewGain gain(map, {}, {}, plain());
  const double alone_m2 = sum(gain.by_sector_m2({0.0, 0.0}));
  gain.leave_to({{1.4, 0.0}, 2.5, 0.0});
  EXPECT_LT(sum(gain.by_sector_m2({0.0, 0.0})), 0.7 * alone_m2);
  EXPECT_LT(gain.worth(map.cell_at({1.6, 0.0})), 0.15) << "right before them";
  EXPECT_GT(gain.worth(map.cell_at({-1.0, 1.6})), 0.9) << "out of their reach";
}

TEST(ViewGain, NobodyElseSeesWhatIsBehindAWall) {
  const RasterMap map = open_to_the_right();
  ViewGain gain(map, {}, {}, plain());
  gain.leave_to({{-1.4, 0.0}, 2.5, 0.0});
  EXPECT_EQ(gain.worth(map.cell_at({-1.7, 0.0})), 1.0);
}

TEST(ViewGain, WhatIsFarCountsLess) {
  const RasterMap map = open_to_the_right();
  auto params = plain();
  params.fade_m = 1.0;
  const ViewGain gain(map, {}, {}, params);
  EXPECT_LT(sum(gain.by_sector_m2({0.0, 0.0})), sum(gain.by_sector_m2({1.0, 0.0})));
}

TEST(ViewGain, WhatIsBesideAWallCountsLess) {
  RasterMap map = open_to_the_right();
  const auto params = plain();
  auto wary = params;
  wary.beside_wall_m = 0.4;
  const Eigen::Vector2d at_m(0.0, 0.0);
  const double far_m2 = sum(ViewGain(map, {}, {}, wary).by_sector_m2(at_m));
  EXPECT_GT(far_m2, 0.9 * sum(ViewGain(map, {}, {}, params).by_sector_m2(at_m)));
  for (int y = 20; y < 80; y += 8) {
    map.set({80, y}, CellState::kOccupied);
  }
  EXPECT_LT(sum(ViewGain(map, {}, {}, wary).by_sector_m2(at_m)), 0.95 * far_m2);
}

TEST(ViewGain, AViewFromInsideAWallShowsNothing) {
  const RasterMap map = open_to_the_right();
  EXPECT_EQ(sum(ViewGain(map, {}, {}, plain()).by_sector_m2({-1.53, 0.0})), 0.0);
}

TEST(ViewGain, RejectsParametersWithoutSense) {
  const RasterMap map = open_to_the_right();
  auto params = plain();
  params.left_by_look = 0.0;
  EXPECT_THROW(ViewGain(map, {}, {}, params), std::invalid_argument);
  params = plain();
  params.novel_m = 0.0;
  EXPECT_THROW(ViewGain(map, {}, {}, params), std::invalid_argument);
  params = plain();
  params.reach_m = -1.0;
  EXPECT_THROW(ViewGain(map, {}, {}, params), std::invalid_argument);
}

TEST(BestView, LiesWhereTheGainIsAndTurnsOverTheBack) {
  std::vector<double> gains_m2(ViewGain::kSectors);
  gains_m2.front() = 1.0;
  gains_m2.back() = 2.0;
  gains_m2[36] = 2.5;
  const BestView behind = best_view(gains_m2, radians(10.0));
  EXPECT_NEAR(behind.gain_m2, 3.0, 1e-12);
  EXPECT_NEAR(std::abs(behind.middle_rad), std::numbers::pi, 1e-9);
  const BestView all_round = best_view(gains_m2, radians(360.0));
  EXPECT_NEAR(all_round.gain_m2, 5.5, 1e-12);
  EXPECT_NEAR(all_round.width_rad, radians(360.0), 1e-12);
}

}  // namespace
}  // namespace echomap::exploration
