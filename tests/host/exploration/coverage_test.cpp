// SPDX-License-Identifier: MIT
#include "host/exploration/coverage.hpp"

#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"
#include "tests/support/told_snapshot.hpp"

namespace echomap::exploration {
namespace {

using geometry::Pose2;
using mapping::OccupancyGrid;

/// Free floor of 4 m x 2 m around (1, 0) with walls all round; `is_wall` draws more of them, and
/// `is_unknown` leaves cells out, by the indices of the cells of 5 cm.
template <class IsWall, class IsUnknown>
pipeline::Snapshot room(IsWall is_wall, IsUnknown is_unknown) {
  OccupancyGrid grid;
  for (int y = -20; y <= 20; ++y) {
    for (int x = -20; x <= 60; ++x) {
      if (!is_unknown(x, y)) {
        const bool wall = x == -20 || x == 60 || std::abs(y) == 20 || is_wall(x, y);
        grid.add({x, y}, wall ? 300 : -300);
      }
    }
  }
  return tests::snapshot_of(std::move(grid), {tests::pose_at(1.0, {})});
}

bool nowhere(int, int) { return false; }

/// The wall at x = 2 m, but for a gap of so many cells around y = 0.
auto wall_with_gap(int half_cells) {
  return [half_cells](int x, int y) { return x == 40 && std::abs(y) > half_cells; };
}

TEST(CoverageOf, ARoomWithinItsWallsIsAll) {
  const Coverage coverage = coverage_of(room(nowhere, nowhere));
  EXPECT_NEAR(coverage.seen_m2, 4.0 * 2.0, 0.4);
  EXPECT_EQ(coverage.unseen_m2, 0.0);
  EXPECT_EQ(coverage.share(), 1.0);
  EXPECT_TRUE(coverage.places.empty());
  EXPECT_TRUE(coverage.gaps.empty());
}

TEST(CoverageOf, FloorThatEndsWithoutAWallGoesOn) {
  const auto end = [](int x, int) { return x > 45; };
  const Coverage coverage = coverage_of(room(nowhere, end));
  EXPECT_LT(coverage.share(), 0.95);
  ASSERT_EQ(coverage.places.size(), 1U);
  EXPECT_NEAR(coverage.places.front().at_m.x(), 2.3 + 0.25, 0.1);
  EXPECT_NEAR(coverage.places.front().at_m.y(), 0.0, 0.1);
  // Half a metre deep and as wide as the room, less beside its walls.
  EXPECT_GT(coverage.places.front().area_m2, 0.5);
  EXPECT_LT(coverage.places.front().area_m2, 1.2);
}

TEST(CoverageOf, WhatLooksHaveLeftUnknownCountsLess) {
  auto snapshot = room(nowhere, [](int x, int) { return x > 45; });
  const double before_m2 = coverage_of(snapshot).unseen_m2;
  mapping::Scan look;
  for (int deg = 0; deg < 360; deg += 4) {
    const Pose2 at(1.8, 0.0, geometry::radians(deg));
    look.push_back({at, at, std::nullopt});
  }
  snapshot.scans = std::make_shared<const std::vector<mapping::Scan>>(2, look);
  EXPECT_LT(coverage_of(snapshot).unseen_m2, 0.35 * before_m2);
}

TEST(CoverageOf, AnIslandIsExpectedToBeFloorHoweverOftenItWasLookedAt) {
  const auto is_island = [](int x, int y) { return x >= 16 && x <= 24 && std::abs(y) <= 4; };
  auto snapshot = room(nowhere, is_island);
  mapping::Scan look;
  for (int deg = 0; deg < 360; deg += 4) {
    const Pose2 at(0.4, 0.0, geometry::radians(deg));
    look.push_back({at, at, std::nullopt});
  }
  snapshot.scans = std::make_shared<const std::vector<mapping::Scan>>(100, look);
  EXPECT_NEAR(coverage_of(snapshot).unseen_m2, ViewGainParams{}.island_floor * 0.45 * 0.45, 0.01);
}

TEST(CoverageOf, BehindAWallInATipWhereTheRobotCannotStandIsNoDoor) {
  auto snapshot = room(wall_with_gap(1), nowhere);
  mapping::SonarFeatures features;
  features.unobserved = {{{3.0, -0.5}, {3.0, 0.5}}};
  snapshot.features = std::make_shared<const mapping::SonarFeatures>(features);
  EXPECT_NEAR(coverage_of(snapshot).unseen_m2, 0.0, 1e-9);
}

TEST(CoverageOf, BehindAWallThatNobodyHasHeardFloorMayBe) {
  auto snapshot = room(nowhere, nowhere);
  mapping::SonarFeatures features;
  features.unobserved = {{{3.0, -0.5}, {3.0, 0.5}}, {{6.0, -0.5}, {6.0, 0.5}}};
  snapshot.features = std::make_shared<const mapping::SonarFeatures>(features);
  const ViewGainParams gain;
  EXPECT_NEAR(coverage_of(snapshot).unseen_m2, gain.unobserved.floor_chance * gain.depth_m, 1e-9)
      << "the other one is nowhere near";
}

TEST(CoverageOf, WallsThatNoStopCouldTellFromDoorsAreNamed) {
  auto snapshot = room(wall_with_gap(1), nowhere);
  mapping::SonarFeatures features;
  features.unheard = {{{-0.4, 1.0}, {-0.9, 1.0}},    // wide enough
                      {{-0.35, 1.0}, {-0.85, 1.0}},  // the same
                      {{-0.9, -1.0}, {0.2, -1.0}},
                      {{0.9, 1.0}, {0.5, 1.0}},    // too narrow
                      {{3.0, -0.5}, {3.0, 0.5}}};  // behind a gap that is too narrow for the robot
  snapshot.features = std::make_shared<const mapping::SonarFeatures>(features);
  const Coverage coverage = coverage_of(snapshot);
  ASSERT_EQ(coverage.doors.size(), 2U);
  EXPECT_NEAR(coverage.doors[0].length_m(), 1.1, 1e-9) << "the widest first";
  EXPECT_NEAR(coverage.doors[1].length_m(), 0.5, 1e-9);
  EXPECT_EQ(coverage.share(), 1.0);

  mapping::Scan look;
  for (int deg = 0; deg < 360; deg += 4) {
    const Pose2 at(-0.4, -0.2, geometry::radians(deg));
    look.push_back({at, at, std::nullopt});
  }
  snapshot.scans = std::make_shared<const std::vector<mapping::Scan>>(1, look);
  const Coverage looked_at = coverage_of(snapshot);
  ASSERT_EQ(looked_at.doors.size(), 1U) << "one stop could tell the wide one";
  EXPECT_NEAR(looked_at.doors[0].length_m(), 0.5, 1e-9);
}

TEST(CoverageOf, AGapThatIsTooNarrowIsToldAndWhatLiesBehindIsOutOfReach) {
  const Coverage coverage = coverage_of(room(wall_with_gap(1), nowhere));
  ASSERT_EQ(coverage.gaps.size(), 1U);
  const NarrowGap& gap = coverage.gaps.front();
  EXPECT_NEAR(gap.at_m.x(), 2.0, 0.1);
  EXPECT_NEAR(gap.at_m.y(), 0.0, 0.06);
  EXPECT_NEAR(gap.width_m, 0.15, 0.051);
  EXPECT_NEAR(gap.behind_m2, 1.0 * 2.0, 0.4);
  EXPECT_NEAR(coverage.seen_m2, 3.0 * 2.0, 0.4);
  EXPECT_EQ(coverage.share(), 1.0) << "of what the robot can reach";
}

TEST(CoverageOf, ADoorThatIsWideEnoughIsNoGap) {
  const Coverage coverage = coverage_of(room(wall_with_gap(8), nowhere));
  EXPECT_TRUE(coverage.gaps.empty());
  EXPECT_NEAR(coverage.seen_m2, 4.0 * 2.0, 0.5);
}

TEST(CoverageOf, WhereTheRobotCameFromIsInItsReachHoweverNarrowTheMapHasTheDoor) {
  auto snapshot = room(wall_with_gap(1), nowhere);
  auto way = std::make_shared<std::vector<pipeline::StampedPose>>();
  for (int i = 0; i <= 30; ++i) {
    way->push_back(tests::pose_at(i, Pose2(0.08 * i, 0.0, 0.0)));
  }
  snapshot.latest = way->back();
  snapshot.trajectory = way;
  const Coverage coverage = coverage_of(snapshot);
  EXPECT_TRUE(coverage.gaps.empty());
  EXPECT_NEAR(coverage.seen_m2, 4.0 * 2.0, 0.5);
}

TEST(CoverageOf, WithoutAMapNothingIsSeen) {
  const auto snapshot = tests::snapshot_of(OccupancyGrid(), {tests::pose_at(1.0, {})});
  EXPECT_LT(coverage_of(snapshot).share(), 0.2);
  EXPECT_EQ(Coverage().share(), 0.0);
}

TEST(CoverageOf, RejectsImpossibleParameters) {
  CoverageParams params;
  params.corner_radii = 0.0;
  EXPECT_THROW(coverage_of(room(nowhere, nowhere), params), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::exploration
