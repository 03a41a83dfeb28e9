// SPDX-License-Identifier: MIT
#include "host/exploration/active_localization.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "tests/host/exploration/obedient_robot.hpp"

namespace echomap::exploration {
namespace {

using geometry::Pose2;

/// A room of 4 m x 4 m around the start.
mapping::OccupancyGrid square_room() {
  mapping::OccupancyGrid grid;
  for (int y = -40; y <= 40; ++y) {
    for (int x = -40; x <= 40; ++x) {
      grid.add({x, y}, std::max(std::abs(x), std::abs(y)) == 40 ? 300 : -300);
    }
  }
  return grid;
}

class ActiveLocalizationTest : public ::testing::Test {
 protected:
  ActiveLocalizationTest() {
    robot.snapshot = tests::snapshot_of(square_room(), {tests::pose_at(1.0, {})});
  }

  /// As a pipeline does: each scan is a stop of the map.
  void go(std::size_t stops) {
    MotionResult last = MotionResult::kReached;
    for (int i = 0; i < 5'000 && stops_m.size() < stops && !finished; ++i) {
      const Motion motion = explorer.next(robot.snapshot, last);
      robot.carry_out(motion);
      last = result_of(motion);
      if (const auto* end = std::get_if<Finished>(&motion)) {
        finished = end->reason;
      }
      if (std::holds_alternative<EndScan>(motion)) {
        stops_m.push_back(robot.snapshot.latest.T_map_robot.position_m());
        const Pose2& T_map_robot = robot.snapshot.latest.T_map_robot;
        scans.push_back({{T_map_robot, T_map_robot, {}}});
        robot.snapshot.scans = std::make_shared<const std::vector<mapping::Scan>>(scans);
        ++robot.snapshot.stops;
      }
    }
  }

  ObedientRobot robot;
  double utility(const Pose2& T_robot_goal) const {
    const Eigen::Vector2d goal_m = (robot.snapshot.latest.T_map_robot * T_robot_goal).position_m();
    return best_m && (goal_m - *best_m).norm() < 0.3 ? 1.0 : 0.0;
  }

  std::optional<Eigen::Vector2d> best_m;
  ActiveLocalization explorer{{}, [this](const Pose2& goal) { return utility(goal); }};
  std::vector<mapping::Scan> scans;
  std::function<MotionResult(const Motion&)> result_of = [](const Motion&) {
    return MotionResult::kReached;
  };
  std::vector<Eigen::Vector2d> stops_m;
  std::optional<FinishReason> finished;
};

TEST_F(ActiveLocalizationTest, SweepsWhereItStandsFirst) {
  go(1);
  ASSERT_EQ(stops_m.size(), 1U);
  EXPECT_LT(stops_m.front().norm(), 1e-9);
}

TEST_F(ActiveLocalizationTest, GoesToThePlaceOfTheGreatestUtility) {
  best_m = {-1.0, 1.2};
  go(2);
  ASSERT_EQ(stops_m.size(), 2U);
  EXPECT_LT((stops_m.back() - *best_m).norm(), 0.35);
}

TEST_F(ActiveLocalizationTest, KeepsApartFromEarlierStopsWhereAllGoalsAreAlike) {
  go(8);
  ASSERT_EQ(stops_m.size(), 8U);
  for (std::size_t one = 0; one < stops_m.size(); ++one) {
    for (std::size_t other = 0; other < one; ++other) {
      EXPECT_GT((stops_m[one] - stops_m[other]).norm(), 0.5) << one << " and " << other;
    }
  }
}

TEST_F(ActiveLocalizationTest, BacksOffFromABumpAndGoesSomewhereElse) {
  bool has_bumped = false;
  bool has_backed_off = false;
  result_of = [&](const Motion& motion) {
    const auto* drive = std::get_if<Drive>(&motion);
    has_backed_off = has_backed_off || (drive != nullptr && drive->distance_m < 0.0);
    return std::holds_alternative<Roll>(motion) && !std::exchange(has_bumped, true)
               ? MotionResult::kBumped
               : MotionResult::kReached;
  };
  best_m = {1.2, 0.0};
  go(2);
  EXPECT_TRUE(has_backed_off);
  ASSERT_EQ(stops_m.size(), 2U);
  EXPECT_GT(stops_m.back().norm(), 0.1);
}

TEST_F(ActiveLocalizationTest, GoesOnInAMapThatHasAStop) {
  robot.snapshot.stops = 1;
  const Motion motion = explorer.next(robot.snapshot, MotionResult::kReached);
  EXPECT_TRUE(std::holds_alternative<Turn>(motion) || std::holds_alternative<Roll>(motion));
}

TEST_F(ActiveLocalizationTest, KnowsNowhereToGoWhereAllIsWall) {
  mapping::OccupancyGrid grid;
  for (int y = -10; y <= 10; ++y) {
    for (int x = -10; x <= 10; ++x) {
      grid.add({x, y}, 300);
    }
  }
  robot.snapshot = tests::snapshot_of(std::move(grid), {tests::pose_at(1.0, {})});
  go(2);
  EXPECT_EQ(stops_m.size(), 1U);
  EXPECT_EQ(finished, FinishReason::kNowhereToGo);
}

TEST_F(ActiveLocalizationTest, EndsWhereNoSweepIsCarriedOut) {
  result_of = [](const Motion& motion) {
    return std::holds_alternative<Sweep>(motion) ? MotionResult::kRefused : MotionResult::kReached;
  };
  go(2);
  EXPECT_EQ(finished, FinishReason::kCannotSense);
}

TEST_F(ActiveLocalizationTest, KeepsApartFromStopsThatHeardNothing) {
  robot.snapshot.stops = 1;
  robot.snapshot.scans =
      std::make_shared<const std::vector<mapping::Scan>>(std::vector<mapping::Scan>(1));
  go(1);
  EXPECT_EQ(stops_m.size(), 1U);
}

TEST_F(ActiveLocalizationTest, GivesUpWhereEveryMoveFails) {
  result_of = [](const Motion& motion) {
    return std::holds_alternative<Roll>(motion) || std::holds_alternative<Turn>(motion)
               ? MotionResult::kStalled
               : MotionResult::kReached;
  };
  go(2);
  EXPECT_EQ(finished, FinishReason::kNowhereToGo);
}

TEST(ActiveLocalization, RejectsInvalidParameters) {
  const auto refused = [](auto change) {
    ActiveLocalizationParams params;
    change(params);
    EXPECT_THROW(ActiveLocalization(params, {}), std::invalid_argument);
  };
  refused([](auto& params) { params.sweep.step_rad = 0.0; });
  refused([](auto& params) { params.lattice_m = 0.0; });
  refused([](auto& params) { params.min_utility = 0.0; });
}

}  // namespace
}  // namespace echomap::exploration
