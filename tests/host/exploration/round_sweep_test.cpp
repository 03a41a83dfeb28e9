// SPDX-License-Identifier: MIT
#include "host/exploration/round_sweep.hpp"

#include <cmath>
#include <map>
#include <numbers>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"

namespace echomap::exploration {
namespace {

using geometry::degrees;
using geometry::radians;

/// How often each bearing, in whole degrees from where the body began, is read.
std::map<int, int> bearings_deg(const std::deque<Motion>& motions) {
  std::map<int, int> times;
  double heading_rad = 0.0;
  for (const Motion& motion : motions) {
    if (const auto* turn = std::get_if<Turn>(&motion)) {
      heading_rad += turn->angle_rad;
    } else if (const auto* sweep = std::get_if<Sweep>(&motion)) {
      const auto steps = std::lround((sweep->to_rad - sweep->from_rad) / sweep->step_rad);
      for (int i = 0; i <= steps; ++i) {
        const double bearing_deg =
            degrees(heading_rad + sweep->from_rad + i * sweep->step_rad) + 720.0;
        ++times[static_cast<int>(std::lround(bearing_deg)) % 360];
      }
    }
  }
  return times;
}

class RoundSweep : public ::testing::TestWithParam<double> {};

TEST_P(RoundSweep, ReadsEveryBearingAsOften) {
  RoundSweepParams params;
  params.pan_limit_rad = radians(GetParam());
  for (const int rounds : {1, 2}) {
    params.scan_rad = rounds * 2.0 * std::numbers::pi;
    for (const bool turned_left : {false, true}) {
      const auto motions = round_sweep(params, turned_left);
      EXPECT_TRUE(std::holds_alternative<BeginScan>(motions.front()));
      EXPECT_TRUE(std::holds_alternative<EndScan>(motions.back()));
      const auto times = bearings_deg(motions);
      ASSERT_EQ(times.size(), 60U);
      for (const auto& [bearing_deg, count] : times) {
        EXPECT_EQ(count, rounds) << bearing_deg;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(PanLimits, RoundSweep, ::testing::Values(90.0, 180.0, 360.0));

TEST(RoundSweepTurns, GoBackToWhereTheBodyCameFrom) {
  const RoundSweepParams params;
  for (const bool turned_left : {false, true}) {
    for (const Motion& motion : round_sweep(params, turned_left)) {
      if (const auto* turn = std::get_if<Turn>(&motion)) {
        EXPECT_EQ(turn->angle_rad < 0.0, turned_left);
      }
    }
  }
}

TEST(RoundSweepParams, MustLeadAllRound) {
  EXPECT_TRUE(is_possible({}));
  EXPECT_FALSE(is_possible({.scan_rad = 6.0}));
  EXPECT_FALSE(is_possible({.step_rad = 0.0}));
  EXPECT_FALSE(is_possible({.pan_limit_rad = 0.01}));
  EXPECT_FALSE(is_possible({.settle_s = -1.0}));
}

long readings_of(const std::deque<Motion>& motions) {
  long count = 0;
  for (const Motion& motion : motions) {
    if (const auto* sweep = std::get_if<Sweep>(&motion)) {
      count += std::lround((sweep->to_rad - sweep->from_rad) / sweep->step_rad) + 1;
    }
  }
  return count;
}

double turned_rad(const std::deque<Motion>& motions) {
  double turned_rad = 0.0;
  for (const Motion& motion : motions) {
    if (const auto* turn = std::get_if<Turn>(&motion)) {
      turned_rad += turn->angle_rad;
    }
  }
  return turned_rad;
}

TEST(StopSweep, ReadsFourTimesAsOftenAtTheFirstStopAndItsFirstSectorTwice) {
  EXPECT_EQ(readings_of(stop_sweep({}, 0, false)), 360);
  EXPECT_NEAR(turned_rad(stop_sweep({}, 0, false)), 2.0 * std::numbers::pi, 1e-9);
  EXPECT_NEAR(turned_rad(stop_sweep({}, 0, true)), -2.0 * std::numbers::pi, 1e-9);
  EXPECT_EQ(readings_of(stop_sweep({}, 1, false)), 60);
}

TEST(StopSweep, EndsWhereItBeganWithAPanThatGoesAllRound) {
  const RoundSweepParams all_round{.pan_limit_rad = std::numbers::pi};
  EXPECT_EQ(readings_of(stop_sweep(all_round, 0, false)), 240);
  EXPECT_EQ(turned_rad(stop_sweep(all_round, 0, false)), 0.0);
}

}  // namespace
}  // namespace echomap::exploration
