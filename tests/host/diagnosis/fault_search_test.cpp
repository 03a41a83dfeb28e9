// SPDX-License-Identifier: MIT
#include "host/diagnosis/fault_search.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/host/diagnosis/box_log.hpp"

namespace echomap::diagnosis {
namespace {

Explanation best_explanation_of(const RobotErrors& errors) {
  BoxLog box(errors);
  return explain(box.tour()).front();
}

TEST(FaultSearch, ExplainsASoundRobotByNoFault) {
  const auto explanations = [] {
    BoxLog box({});
    return explain(box.tour());
  }();
  double sound = 0.0;
  for (const Explanation& one : explanations) {
    sound = one.fault.kind == FaultKind::kNone ? one.log_posterior : sound;
  }
  EXPECT_LT(explanations.front().log_posterior - sound, 0.1);
}

TEST(FaultSearch, FindsAWheelOfAnotherSizeAndHowLargeItIs) {
  RobotErrors errors;
  errors.left_scale = 1.08;
  const Explanation best = best_explanation_of(errors);
  EXPECT_EQ(best.fault.kind, FaultKind::kLeftWheelSize);
  EXPECT_NEAR(best.fault.value, 1.08, 0.02);
}

TEST(FaultSearch, FindsWhichWheelIsReversed) {
  RobotErrors errors;
  errors.right_scale = -1.0;
  EXPECT_EQ(best_explanation_of(errors).fault.kind, FaultKind::kRightReversed);
  errors.left_scale = -1.0;
  EXPECT_EQ(best_explanation_of(errors).fault.kind, FaultKind::kBothReversed);
}

TEST(FaultSearch, FindsHalfTheCounts) {
  RobotErrors errors;
  errors.left_scale = errors.right_scale = 2.0;
  const Explanation best = best_explanation_of(errors);
  EXPECT_EQ(best.fault.kind, FaultKind::kCounts);
  EXPECT_NEAR(best.fault.value, 0.5, 0.02);
}

TEST(FaultSearch, FindsWhatIsWrongWithThePan) {
  RobotErrors errors;
  errors.pan_scale = -1.0;
  EXPECT_EQ(best_explanation_of(errors).fault.kind, FaultKind::kPanReversed);
  errors.pan_scale = 1.0;
  errors.pan_offset_rad = 0.12;
  const Explanation best = best_explanation_of(errors);
  EXPECT_EQ(best.fault.kind, FaultKind::kPanOffset);
  EXPECT_NEAR(best.fault.value, 0.12, 0.03);
}

TEST(FaultSearch, FindsRangesThatAreTooLong) {
  RobotErrors errors;
  errors.range_scale = 0.9;
  const Explanation best = best_explanation_of(errors);
  EXPECT_EQ(best.fault.kind, FaultKind::kRangeScale);
  EXPECT_NEAR(best.fault.value, 0.9, 0.02);
}

}  // namespace
}  // namespace echomap::diagnosis
