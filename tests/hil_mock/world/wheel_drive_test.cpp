// SPDX-License-Identifier: MIT
#include "hil_mock/world/wheel_drive.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "tests/hil_mock/world/steps.hpp"

namespace echomap::world {
namespace {

/// Decodes A and B as a quadrature counter does; illegal transitions fail the test.
class Quadrature {
 public:
  void on(const LevelChange& change) {
    const int phase = change.b ? (change.a ? 2 : 3) : (change.a ? 1 : 0);
    const int difference = (phase - phase_ + 4) % 4;
    EXPECT_NE(difference, 0);
    EXPECT_NE(difference, 2);
    count_ += difference == 1 ? 1 : -1;
    phase_ = phase;
  }
  int count() const { return count_; }

 private:
  int phase_ = 0;
  int count_ = 0;
};

TEST(WheelDrive, ReachesTheSpeedOfItsDutyInItsTime) {
  DriveParams params;
  WheelDrive wheel(params, params.wheel_diameter_m, 1.0);
  std::vector<LevelChange> changes;
  double after_one_constant_m = 0.0;
  for (int i = 0; i < 80; ++i) {
    after_one_constant_m = wheel.step(kStepS, {1.0}, changes);
  }
  EXPECT_NEAR(after_one_constant_m / kStepS, 0.45 * (1.0 - std::exp(-1.0)), 0.003);
  for (int i = 0; i < 1000; ++i) {
    wheel.step(kStepS, {1.0}, changes);
  }
  EXPECT_NEAR(wheel.step(kStepS, {1.0}, changes) / kStepS, 0.45, 1e-4);
}

TEST(WheelDrive, StandsStillInItsDeadZone) {
  DriveParams params;
  WheelDrive wheel(params, params.wheel_diameter_m, 1.0);
  std::vector<LevelChange> changes;
  for (int i = 0; i < 1000; ++i) {
    EXPECT_EQ(wheel.step(kStepS, {0.119}, changes), 0.0);
  }
  EXPECT_TRUE(changes.empty());
}

TEST(WheelDrive, RollsOneTurnInCountsPerTurn) {
  DriveParams params;
  WheelDrive wheel(params, 0.1, 1.0);
  std::vector<LevelChange> changes;
  double rolled_m = 0.0;
  while (wheel.counts() < 1496) {
    rolled_m += wheel.step(kStepS, {0.5}, changes);
  }
  EXPECT_NEAR(rolled_m, 0.1 * std::numbers::pi, 0.002 * std::numbers::pi);
}

TEST(WheelDrive, EdgesAreWhatTheCounterSaysAndInOrder) {
  DriveParams params;
  WheelDrive wheel(params, params.wheel_diameter_m, 1.0);
  Quadrature counter;
  for (int step = 0; step < 4000; ++step) {
    std::vector<LevelChange> changes;
    wheel.step(kStepS, {std::sin(step * 0.004)}, changes);
    double before_s = 0.0;
    for (const LevelChange& change : changes) {
      EXPECT_GE(change.at_s, before_s);
      EXPECT_LE(change.at_s, kStepS);
      before_s = change.at_s;
      counter.on(change);
    }
    ASSERT_EQ(counter.count(), wheel.counts());
  }
  EXPECT_NE(wheel.counts(), 0);
}

/// Milliseconds until a wheel at full speed has lost all but 1/e of it.
int ms_to_slow_down(const MotorDrive& drive) {
  DriveParams params;
  WheelDrive wheel(params, params.wheel_diameter_m, 1.0);
  std::vector<LevelChange> changes;
  for (int i = 0; i < 2000; ++i) {
    wheel.step(kStepS, {1.0}, changes);
  }
  int ms = 0;
  while (wheel.speed_share() > std::exp(-1.0)) {
    wheel.step(kStepS, drive, changes);
    ++ms;
  }
  return ms;
}

TEST(WheelDrive, StopsFasterWhenItBrakesThanWhenItCoasts) {
  const DriveParams params;
  EXPECT_NEAR(ms_to_slow_down({0.0, 0.0}), 1000 * params.time_constant_s, 1.1);
  // dv/dt = -v / coast_time_constant_s - dead_zone_duty / time_constant_s
  const double rubs = params.dead_zone_duty * params.coast_time_constant_s / params.time_constant_s;
  const double coasts_s =
      params.coast_time_constant_s * std::log((1.0 + rubs) / (std::exp(-1.0) + rubs));
  EXPECT_NEAR(ms_to_slow_down({0.0, 1.0}), 1000 * coasts_s, 1.6);
}

double speed_at(const MotorDrive& drive) {
  DriveParams params;
  WheelDrive wheel(params, params.wheel_diameter_m, 1.0);
  std::vector<LevelChange> changes;
  for (int i = 0; i < 3000; ++i) {
    wheel.step(kStepS, drive, changes);
  }
  return wheel.speed_share();
}

TEST(WheelDrive, IsFasterWhereThePausesOfThePwmLetItRoll) {
  EXPECT_NEAR(speed_at({0.56, 0.0}), 0.5, 1e-6);
  EXPECT_NEAR(speed_at({0.56, 0.44}), 0.5 / (0.56 + 0.44 / 3.0), 1e-6);
  EXPECT_NEAR(speed_at({1.0, 0.0}), 1.0, 1e-6);
}

TEST(WheelDrive, BackwardCountsDown) {
  DriveParams params;
  WheelDrive wheel(params, params.wheel_diameter_m, 1.0);
  std::vector<LevelChange> changes;
  for (int i = 0; i < 500; ++i) {
    wheel.step(kStepS, {-1.0}, changes);
  }
  EXPECT_EQ(wheel.counts(), -static_cast<std::int64_t>(changes.size()));
  EXPECT_LT(wheel.counts(), -1000);
}

}  // namespace
}  // namespace echomap::world
