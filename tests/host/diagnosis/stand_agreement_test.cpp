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

}  // namespace
}  // namespace echomap::diagnosis
