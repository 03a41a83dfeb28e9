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

TEST(StopSweep, ReadsFourTimesAsOftenAtTheFirstStop) {
  const auto readings = [](std::size_t stops) {
    long count = 0;
    for (const Motion& motion : stop_sweep({}, stops, false)) {
      if (const auto* sweep = std::get_if<Sweep>(&motion)) {
        count += std::lround((sweep->to_rad - sweep->from_rad) / sweep->step_rad) + 1;
      }
    }
    return count;
  };
  EXPECT_EQ(readings(0), 240);
  EXPECT_EQ(readings(1), 60);
}

}  // namespace
}  // namespace echomap::exploration
