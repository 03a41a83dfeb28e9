// SPDX-License-Identifier: MIT
#include "host/diagnosis/stand_agreement.hpp"

#include <gtest/gtest.h>

#include "tests/host/diagnosis/box_log.hpp"

namespace echomap::diagnosis {
namespace {

TEST(StandAgreement, IsHighestForTheErrorsThatTheRobotHas) {
  RobotErrors truth;
  truth.left_scale = 1.05;
  truth.pan_offset_rad = 0.05;
  BoxLog box(truth);
  const StandLog& log = box.tour();
  const double best = log_agreement(log, truth);
  EXPECT_GT(best, log_agreement(log, {}) + 5.0);
  RobotErrors reversed = truth;
  reversed.right_scale = -1.0;
  EXPECT_GT(best, log_agreement(log, reversed) + 5.0);
}

TEST(StandAgreement, OfOneStandSaysNothing) {
  BoxLog box({});
  box.stand().drive(0.1);
  EXPECT_EQ(log_agreement(box.log(), {}), 0.0);
}

TEST(StandAgreement, DoesNotReachAcrossABrokenWay) {
  BoxLog box({});
  box.stand();
  box.log().break_way();
  box.drive(0.3).stand();
  EXPECT_EQ(log_agreement(box.log(), {}), 0.0);
}

TEST(StandAgreement, GrowsByThePingsOfADriveOnlyForTheRobotThatHasDrivenIt) {
  RobotErrors truth;
  truth.range_scale = 0.9;
  BoxLog box(truth);
  box.stand();
  for (int i = 0; i < 10; ++i) {
    box.drive(0.1).ping(0.0);
  }
  box.drive(0.1);
  EXPECT_GT(log_agreement(box.log(), truth), log_agreement(box.log(), {}) + 2.0);
}

TEST(StandAgreement, OfPingsDoesNotReachAcrossABrokenWay) {
  BoxLog box({});
  box.stand();
  box.log().break_way();
  box.drive(0.1).ping(0.0).drive(0.1);
  ASSERT_EQ(box.log().rolling_pings().size(), 1U);
  EXPECT_EQ(log_agreement(box.log(), {}), 0.0);
}

}  // namespace
}  // namespace echomap::diagnosis
