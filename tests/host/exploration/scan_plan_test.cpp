// SPDX-License-Identifier: MIT
#include "host/exploration/scan_plan.hpp"

#include <variant>

#include <gtest/gtest.h>

namespace echomap::exploration {
namespace {

TEST(ScanPlan, HandsTheMotionsOutInOrder) {
  ScanPlan plan;
  EXPECT_FALSE(plan.next());
  EXPECT_TRUE(std::holds_alternative<BeginScan>(plan.begin({BeginScan{}, Turn{1.0}, EndScan{}})));
  EXPECT_TRUE(std::holds_alternative<Turn>(plan.next().value()));
  EXPECT_TRUE(std::holds_alternative<EndScan>(plan.next().value()));
  EXPECT_FALSE(plan.next());
}

TEST(ScanPlan, KnowsWhetherASweepWasCarriedOut) {
  ScanPlan plan;
  plan.begin({Turn{1.0}, Sweep{}, Sweep{}, EndScan{}});
  plan.end_motion(MotionResult::kReached);
  EXPECT_FALSE(plan.has_swept()) << "a turn is none";
  plan.next();
  plan.end_motion(MotionResult::kReached);
  plan.next();
  plan.end_motion(MotionResult::kRefused);
  EXPECT_TRUE(plan.has_swept()) << "one of two";
  plan.begin({Sweep{}});
  EXPECT_FALSE(plan.has_swept()) << "at another stop";
  plan.end_motion(MotionResult::kTimedOut);
  plan.end_motion(MotionResult::kReached);
  EXPECT_FALSE(plan.has_swept());
}

}  // namespace
}  // namespace echomap::exploration
