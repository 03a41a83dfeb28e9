// SPDX-License-Identifier: MIT
#include "tests/benchmarks/stop_choice.hpp"

#include <gtest/gtest.h>

namespace echomap::bench {
namespace {

using geometry::Polygon;

/// Two chambers of 2 x 2 m, joined by a door of 0.6 m in a wall of 0.2 m.
world::FloorPlan two_chambers() {
  const Polygon outline_m{{0.0, 0.0},
                          {2.0, 0.0},
                          {2.0, 0.7},
                          {2.2, 0.7},
                          {2.2, 0.0},
                          {4.2, 0.0},
                          {4.2, 2.0},
                          {2.2, 2.0},
                          {2.2, 1.3},
                          {2.0, 1.3},
                          {2.0, 2.0},
                          {0.0, 2.0}};
  return {"chambers", {outline_m, {}}, {}, {0.5, 0.5, 0.0}};
}

TEST(StopChoice, BeginsWithTheFirstAndTakesWhatShowsMostThatIsNew) {
  StopChoiceParams params;
  params.max_stops = 2;
  const Eigen::Vector2d beside_m(1.0, 0.5);
  const Eigen::Vector2d in_the_other_m(3.2, 1.0);
  const auto stops_m = choose_stops(two_chambers(), {beside_m, in_the_other_m}, {0.5, 0.5}, params);
  ASSERT_EQ(stops_m.size(), 2U);
  EXPECT_EQ(stops_m[0], Eigen::Vector2d(0.5, 0.5));
  EXPECT_EQ(stops_m[1], in_the_other_m);
}

TEST(StopChoice, LeavesOutWhatIsTooNearToAStopAndWhatShowsNothing) {
  StopChoiceParams params;
  params.apart_share = 0.1;
  EXPECT_EQ(choose_stops(two_chambers(), {{0.6, 0.5}}, {0.5, 0.5}, params).size(), 1U);
  params.min_gain_per_side_m = 100.0;
  params.max_gap_share = 100.0;
  EXPECT_EQ(choose_stops(two_chambers(), {{3.2, 1.0}}, {0.5, 0.5}, params).size(), 1U);
}

TEST(StopChoice, FillsTheGapsBetweenStops) {
  StopChoiceParams params;
  params.min_gain_per_side_m = 100.0;
  params.max_gap_share = 0.5;
  const auto stops_m =
      choose_stops(two_chambers(), {{0.6, 0.5}, {3.2, 1.0}, {3.4, 1.0}}, {0.5, 0.5}, params);
  ASSERT_EQ(stops_m.size(), 2U);
  EXPECT_EQ(stops_m[1], Eigen::Vector2d(3.4, 1.0));
}

}  // namespace
}  // namespace echomap::bench
