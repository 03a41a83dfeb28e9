// SPDX-License-Identifier: MIT
#include "host/exploration/nxt_rounds.hpp"

#include <numbers>
#include <set>
#include <stdexcept>

#include <gtest/gtest.h>

namespace echomap::exploration {
namespace {

using geometry::degrees;
using geometry::radians;

/// Motions until it is finished.
std::vector<Motion> motions_of(const NxtRoundsParams& params) {
  NxtRounds rounds(params);
  std::vector<Motion> motions;
  do {
    motions.push_back(rounds.next({}, MotionResult::kReached));
  } while (!std::holds_alternative<Finished>(motions.back()));
  return motions;
}

/// Of the first scan, from the robot as it stood at its beginning, whole degrees from 0 to 359.
std::multiset<long> bearings_deg(const std::vector<Motion>& motions) {
  std::multiset<long> bearings;
  double turned_rad = 0.0;
  for (const Motion& motion : motions) {
    if (std::holds_alternative<EndScan>(motion)) {
      break;
    }
    if (const auto* turn = std::get_if<Turn>(&motion)) {
      turned_rad += turn->angle_rad;
    } else if (const auto* sweep = std::get_if<Sweep>(&motion)) {
      for (double pan_rad = sweep->from_rad; pan_rad < sweep->to_rad + 1e-6;
           pan_rad += sweep->step_rad) {
        bearings.insert((std::lround(degrees(turned_rad + pan_rad)) + 720) % 360);
      }
    }
  }
  return bearings;
}

TEST(NxtRounds, ReadsEightBearingsFromThirtyDegreesOnHoweverFarItPans) {
  const std::multiset<long> eight{30, 75, 120, 165, 210, 255, 300, 345};
  for (const double limit_deg : {180.0, 90.0, 60.0, 30.0}) {
    EXPECT_EQ(bearings_deg(motions_of({.pan_limit_rad = radians(limit_deg)})), eight) << limit_deg;
  }
  EXPECT_EQ(round_bearings_rad({}).size(), 8U);
}

TEST(NxtRounds, TurnsAndDrivesBetweenItsTenRounds) {
  int scans = 0;
  double turned_rad = 0.0;
  double driven_m = 0.0;
  for (const Motion& motion : motions_of({})) {
    scans += std::holds_alternative<EndScan>(motion) ? 1 : 0;
    if (const auto* turn = std::get_if<Turn>(&motion)) {
      turned_rad += turn->angle_rad;
    } else if (const auto* drive = std::get_if<Drive>(&motion)) {
      driven_m += drive->distance_m;
    }
  }
  EXPECT_EQ(scans, 10);
  EXPECT_NEAR(turned_rad, std::numbers::pi, 1e-9) << "9 times 20 degrees";
  EXPECT_NEAR(driven_m, 0.54, 1e-9);
}

TEST(NxtRounds, GoesOnWhereADriveIsCutShortAndEndsWhereItIsLifted) {
  NxtRounds rounds({});
  rounds.next({}, MotionResult::kReached);
  EXPECT_FALSE(std::holds_alternative<Finished>(rounds.next({}, MotionResult::kBumped)));
  const auto end = std::get<Finished>(rounds.next({}, MotionResult::kLifted));
  EXPECT_EQ(end.reason, FinishReason::kLifted);
}

TEST(NxtRounds, RefusesAPanThatReachesNoBearing) {
  EXPECT_THROW(NxtRounds({.pan_limit_rad = 0.1}), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::exploration
