// SPDX-License-Identifier: MIT
#include "host/mapping/wall_completion.hpp"

#include <cmath>
#include <numbers>
#include <optional>

#include <gtest/gtest.h>

namespace echomap::mapping {
namespace {

constexpr double kQuarter = 0.5 * std::numbers::pi;

/// The wall x = 2, seen from y = -1 to `to_m`, and the wall y = 1, seen from x = 0 to 1.8; for the
/// second, points along it count against x.
std::vector<MatchedWall> corner_with_a_gap(double to_m) {
  return {{0.0, 2.0, {{-1.0, to_m}}}, {kQuarter, 1.0, {{-1.8, 0.0}}}};
}

std::vector<MatchedWall> completed(const std::vector<MatchedWall>& walls,
                                   const std::vector<ScanSurfaces>& scans = {},
                                   const std::vector<Eigen::Vector2d>& track_m = {},
                                   const WallCompletionParams& params = {}) {
  const MatchedSurfaces matched{walls, {}};
  return WallCompletion(matched, scans, track_m, params).completed(matched);
}

TEST(WallCompletion, ProlongsBothWallsToWhereTheyMeet) {
  const auto walls = completed(corner_with_a_gap(0.7));
  EXPECT_NEAR(walls[0].pieces[0].to_m, 1.0, 1e-9);
  EXPECT_NEAR(walls[0].pieces[0].from_m, -1.0, 1e-9) << "nothing meets that end";
  EXPECT_NEAR(walls[1].pieces[0].from_m, -2.0, 1e-9);
  EXPECT_NEAR(walls[1].pieces[0].to_m, 0.0, 1e-9);
}

TEST(WallCompletion, LeavesAGapThatIsTooWide) {
  const auto walls = completed(corner_with_a_gap(0.3));
  EXPECT_NEAR(walls[0].pieces[0].to_m, 0.3, 1e-9);
}

TEST(WallCompletion, LeavesAGapThroughWhichSomethingWasHeard) {
  ScanSurfaces scan;
  scan.center_m = {1.0, 0.85};
  scan.surfaces.push_back({0.0, 2.0, 0.0, 10});
  const auto walls = completed(corner_with_a_gap(0.7), {scan});
  EXPECT_NEAR(walls[0].pieces[0].to_m, 0.7, 1e-9);
  EXPECT_NEAR(walls[1].pieces[0].from_m, -2.0, 1e-9) << "the other's gap was not looked through";
}

TEST(WallCompletion, TakesTheWallItselfForNothingBehindIt) {
  ScanSurfaces scan;
  scan.center_m = {1.0, 0.85};
  scan.surfaces.push_back({0.0, 1.05, 0.0, 10});
  const auto walls = completed(corner_with_a_gap(0.7), {scan});
  EXPECT_NEAR(walls[0].pieces[0].to_m, 1.0, 1e-9);
}

TEST(WallCompletion, JoinsNoWallsThatHardlyTurn) {
  std::vector<MatchedWall> walls = corner_with_a_gap(0.7);
  walls[1].normal_rad = 0.3;
  EXPECT_NEAR(completed(walls)[0].pieces[0].to_m, 0.7, 1e-9);
}

/// The wall x = 2 in two pieces, a metre apart.
const std::vector<MatchedWall> kTwoPieces{{0.0, 2.0, {{-1.5, -0.5}, {0.5, 1.5}}}};

TEST(WallCompletion, BridgesAGapThroughWhichNothingWasHeard) {
  const auto walls = completed(kTwoPieces);
  ASSERT_EQ(walls[0].pieces.size(), 1U);
  EXPECT_NEAR(walls[0].pieces[0].from_m, -1.5, 1e-9);
  EXPECT_NEAR(walls[0].pieces[0].to_m, 1.5, 1e-9);
}

/// A stop a metre before the middle of the gap that has listened all round and heard this range
/// where the wall would answer, or nothing.
ScanSurfaces before_the_gap(std::optional<double> range_m, double at_m = 0.0) {
  ScanSurfaces scan;
  scan.center_m = {1.0, at_m};
  for (int i = 0; i < 90; ++i) {
    const double bearing_rad = -std::numbers::pi + i * std::numbers::pi / 45.0;
    scan.looks.push_back({bearing_rad, std::abs(bearing_rad) < 0.2 ? range_m : std::nullopt});
  }
  return scan;
}

TEST(WallCompletion, LeavesAGapOpenThatDidNotAnswerAStopBeforeIt) {
  EXPECT_EQ(completed(kTwoPieces, {before_the_gap(std::nullopt)})[0].pieces.size(), 2U);
  EXPECT_EQ(completed(kTwoPieces, {before_the_gap(1.5)})[0].pieces.size(), 2U);
  EXPECT_EQ(completed(kTwoPieces, {before_the_gap(1.02)})[0].pieces.size(), 1U) << "the wall";
  EXPECT_EQ(completed(kTwoPieces, {before_the_gap(0.5)})[0].pieces.size(), 1U)
      << "what is nearer answers first";
  EXPECT_EQ(completed(kTwoPieces, {before_the_gap(std::nullopt, 1.0)})[0].pieces.size(), 1U)
      << "it does not face the gap";
  WallCompletionParams near;
  near.faced_range_m = 0.9;
  EXPECT_EQ(completed(kTwoPieces, {before_the_gap(std::nullopt)}, {}, near)[0].pieces.size(), 1U)
      << "no answer reaches that stop";
}

TEST(WallCompletion, TellsAGapFromAWallByHowFarItsEndsAre) {
  // Ends half a metre beside the foot are 12 cm farther off than a wall would be, 0.25 m 3 cm.
  EXPECT_EQ(completed(kTwoPieces, {before_the_gap(1.09)})[0].pieces.size(), 2U);
  EXPECT_EQ(completed(kTwoPieces, {before_the_gap(1.04)})[0].pieces.size(), 1U);
  EXPECT_EQ(completed(kTwoPieces, {before_the_gap(1.09, 0.25)})[0].pieces.size(), 1U)
      << "too near to one end to tell";
}

TEST(WallCompletion, OpensWhatWasClaimedButNotHeard) {
  std::vector<MatchedWall> claimed{{0.0, 2.0, {{-1.5, 1.5}}, {{-1.5, -0.5}, {0.5, 1.5}}}};
  EXPECT_EQ(completed(claimed, {before_the_gap(1.02)})[0].pieces.size(), 1U);
  EXPECT_EQ(completed(claimed, {before_the_gap(1.5)})[0].pieces.size(), 2U);
  claimed[0].heard = {{-1.5, 1.5}};
  EXPECT_EQ(completed(claimed, {before_the_gap(1.5)})[0].pieces.size(), 1U) << "it was heard";
}

TEST(EndExcessM, IsHowMuchFartherTheNearerEndIs) {
  const geometry::Segment gap{{2.0, 0.0}, {2.0, 1.0}};
  EXPECT_NEAR(end_excess_m({1.6, 0.3}, gap), 0.1, 1e-12);
  EXPECT_NEAR(end_excess_m({1.6, 0.7}, gap), 0.1, 1e-12);
  EXPECT_EQ(end_excess_m({1.6, -0.1}, gap), 0.0);
}

TEST(GapsBetween, AreWhatLiesBesideAndBetween) {
  const auto gaps = gaps_between({{-2.0, -1.0}, {-0.5, 0.0}, {3.0, 4.0}}, {-1.5, 1.0});
  ASSERT_EQ(gaps.size(), 2U);
  EXPECT_EQ(gaps[0].from_m, -1.0);
  EXPECT_EQ(gaps[0].to_m, -0.5);
  EXPECT_EQ(gaps[1].from_m, 0.0);
  EXPECT_EQ(gaps[1].to_m, 1.0);
}

TEST(WallCompletion, LeavesADoorOpenThatTheRobotHasDrivenThrough) {
  EXPECT_EQ(completed(kTwoPieces, {}, {{1.9, 0.0}, {2.1, 0.0}})[0].pieces.size(), 2U);
  EXPECT_EQ(completed(kTwoPieces, {}, {{1.9, 0.0}, {2.9, 0.0}})[0].pieces.size(), 1U)
      << "it was carried there";
}

TEST(WallCompletion, ProlongsAWallToAPostOnItsLine) {
  MatchedSurfaces matched{{{0.0, 2.0, {{-1.0, 0.5}}}}, {}};
  matched.features.push_back({{LandmarkKind::kPoint, {2.03, 1.1}}, {}});
  matched.features.push_back({{LandmarkKind::kPoint, {2.2, 1.2}}, {}});
  const auto walls = WallCompletion(matched, {}, {}, {}).completed(matched);
  EXPECT_NEAR(walls[0].pieces[0].to_m, 1.1, 1e-9);
  EXPECT_NEAR(walls[0].pieces[0].from_m, -1.0, 1e-9);
}

}  // namespace
}  // namespace echomap::mapping
