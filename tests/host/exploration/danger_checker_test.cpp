// SPDX-License-Identifier: MIT
#include "host/exploration/danger_checker.hpp"

#include <memory>
#include <stdexcept>
#include <utility>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/smooth_room.hpp"
#include "tests/support/told_snapshot.hpp"

namespace echomap::exploration {
namespace {

/// Asks for one and the same motion, and keeps what it was told.
class Stubborn final : public Explorer {
 public:
  Stubborn(const Motion& motion, std::vector<MotionResult>& told) : motion_(motion), told_(told) {}
  Motion next(const pipeline::Snapshot& /*snapshot*/, MotionResult last) override {
    told_.push_back(last);
    return motion_;
  }

 private:
  Motion motion_;
  std::vector<MotionResult>& told_;
};

/// Free floor around the start, and a wall across the way at 1 m.
mapping::OccupancyGrid floor_before_a_wall() {
  mapping::OccupancyGrid grid;
  for (int y = -30; y < 30; ++y) {
    for (int x = -30; x < 20; ++x) {
      grid.add({x, y}, -400);
    }
    grid.add({20, y}, 400);
  }
  return grid;
}

class DangerCheckerTest : public testing::Test {
 protected:
  DangerChecker checker(const Motion& motion) {
    return {std::make_unique<Stubborn>(motion, told), params};
  }
  static std::optional<FinishReason> reason_of(const Motion& motion) {
    const auto* finished = std::get_if<Finished>(&motion);
    return finished != nullptr ? std::optional(finished->reason) : std::nullopt;
  }
  void report_battery(double voltage_v) {
    stamp += std::chrono::seconds(1);
    snapshot.battery = sensors::BatteryObservation{stamp, voltage_v};
  }

  DangerCheckerParams params;
  std::vector<MotionResult> told;
  pipeline::Snapshot snapshot = tests::snapshot_of(floor_before_a_wall());
  time::RobotTime stamp;
};

TEST_F(DangerCheckerTest, LeavesTheWaysOfAStrategyThatChecksThemItself) {
  params.shortens_drives = false;
  DangerChecker explorer = checker(Drive{1.5});
  EXPECT_EQ(std::get<Drive>(explorer.next(snapshot, MotionResult::kReached)).distance_m, 1.5);
}

TEST_F(DangerCheckerTest, LetsASafeMotionBe) {
  auto safe = checker(Drive{0.5});
  EXPECT_EQ(std::get<Drive>(safe.next(snapshot, MotionResult::kReached)).distance_m, 0.5);
  auto backwards = checker(Drive{-0.05});
  EXPECT_EQ(std::get<Drive>(backwards.next(snapshot, MotionResult::kReached)).distance_m, -0.05);
}

TEST_F(DangerCheckerTest, EndsADriveBeforeAWall) {
  auto far = checker(Drive{3.0});
  const double distance_m = std::get<Drive>(far.next(snapshot, MotionResult::kReached)).distance_m;
  EXPECT_NEAR(distance_m, 1.025 - params.robot_radius_m - params.min_clearance_m, 0.01);
}

TEST_F(DangerCheckerTest, DoesNotBeginADriveIntoAWall) {
  snapshot.latest.T_map_robot = {0.92, 0.0, 0.0};
  auto into = checker(Drive{0.3});
  EXPECT_EQ(reason_of(into.next(snapshot, MotionResult::kReached)), FinishReason::kStuck);
  ASSERT_GT(told.size(), 1U) << "it may ask for something else";
  EXPECT_EQ(told[1], MotionResult::kRefused);
}

TEST_F(DangerCheckerTest, CallsARobotStuckThatGetsNowhere) {
  auto held = checker(Turn{1.0});
  std::size_t asked = 0;
  while (!reason_of(held.next(snapshot, MotionResult::kStalled))) {
    ASSERT_LT(++asked, 100U);
  }
  EXPECT_EQ(asked + 1, params.max_failures);
}

TEST_F(DangerCheckerTest, ForgetsFailuresOnceTheRobotHasGotOn) {
  auto bumping = checker(Turn{1.0});
  for (int i = 0; i < 100; ++i) {
    snapshot.latest.T_map_robot = {0.05 * i, 0.0, 0.0};
    ASSERT_FALSE(reason_of(bumping.next(snapshot, MotionResult::kBumped)));
  }
}

TEST_F(DangerCheckerTest, NoticesWheelsThatTurnWhereTheWorldDoesNot) {
  const auto room = tests::smooth_rectangle();
  auto slipping = checker(Turn{1.0});
  snapshot.last_scan = std::make_shared<const mapping::Scan>(tests::scan_of(room));
  for (std::size_t stop = 1; stop <= 1 + params.max_same_views; ++stop) {
    ASSERT_FALSE(reason_of(slipping.next(snapshot, MotionResult::kReached)));
    snapshot.stops = stop;
    snapshot.latest.T_map_robot = {0.3 * static_cast<double>(stop), 0.0, 0.0};
  }
  EXPECT_EQ(reason_of(slipping.next(snapshot, MotionResult::kReached)), FinishReason::kStuck);
}

TEST_F(DangerCheckerTest, EndsOffTheFloor) {
  auto any = checker(Turn{1.0});
  snapshot.hazards.lifted = true;
  EXPECT_EQ(reason_of(any.next(snapshot, MotionResult::kLifted)), FinishReason::kLifted);
}

TEST_F(DangerCheckerTest, GoesHomeWithALowBatteryAndEndsThere) {
  params.return_below_v = 13.0;
  auto low = checker(Turn{1.0});
  snapshot.latest.T_map_robot = {-0.5, 0.0, 0.0};
  report_battery(12.5);
  const Motion motion = low.next(snapshot, MotionResult::kReached);
  EXPECT_TRUE(std::holds_alternative<Roll>(motion)) << "the start lies straight ahead";
  EXPECT_TRUE(told.empty()) << "the strategy is not asked any more";
  snapshot.latest.T_map_robot = {};
  EXPECT_EQ(reason_of(low.next(snapshot, MotionResult::kReached)), FinishReason::kBatteryLow);
}

TEST_F(DangerCheckerTest, TakesNoShortDropForALowBattery) {
  params.return_below_v = 13.0;
  params.stop_below_v = 12.0;
  auto loaded = checker(Turn{1.0});
  report_battery(14.0);
  loaded.next(snapshot, MotionResult::kReached);
  report_battery(11.0);
  EXPECT_TRUE(std::holds_alternative<Turn>(loaded.next(snapshot, MotionResult::kReached)));
  std::optional<FinishReason> reason;
  for (int i = 0; i < 200 && !reason; ++i) {
    report_battery(11.0);
    reason = reason_of(loaded.next(snapshot, MotionResult::kReached));
  }
  EXPECT_EQ(reason, FinishReason::kBatteryLow);
}

TEST_F(DangerCheckerTest, RefusesParametersWithoutSense) {
  EXPECT_THROW(DangerChecker(nullptr, {}), std::invalid_argument);
  params.robot_radius_m = 0.0;
  EXPECT_THROW(checker(Turn{1.0}), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::exploration
