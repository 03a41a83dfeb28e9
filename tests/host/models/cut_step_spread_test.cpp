// SPDX-License-Identifier: MIT
#include "host/models/cut_step_spread.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace echomap::models {
namespace {

TEST(CutStepSpread, OfAWholeStepIsTheModels) {
  const OdometryMotion motion;
  const OdometryStep step{0.0, 0.2, 0.0};
  const MotionSpread cut = cut_step_spread(motion, step, {.drive_m = 0.2, .turn_rad = 0.5});
  const MotionSpread whole = motion.spread(step);
  EXPECT_DOUBLE_EQ(cut.drive_m, whole.drive_m);
  EXPECT_DOUBLE_EQ(cut.turn_before_rad, whole.turn_before_rad);
  EXPECT_DOUBLE_EQ(cut.turn_after_rad, whole.turn_after_rad);
  EXPECT_DOUBLE_EQ(cut.side_m, whole.side_m);
}

TEST(CutStepSpread, VariancesOfPartsComeToTheSameSum) {
  const OdometryMotion motion;
  for (const int parts : {1, 3, 100, 10000}) {
    const OdometryStep part{0.4 / parts, 1.5 / parts, 0.3 / parts};
    const MotionSpread spread = cut_step_spread(motion, part, {});
    const MotionSpread once = cut_step_spread(motion, {0.4, 1.5, 0.3}, {});
    EXPECT_NEAR(parts * std::pow(spread.drive_m, 2), std::pow(once.drive_m, 2), 1e-12) << parts;
    EXPECT_NEAR(
        parts * std::pow(spread.turn_before_rad, 2), std::pow(once.turn_before_rad, 2), 1e-12)
        << parts;
  }
}

TEST(CutStepSpread, IsNothingWhereTheRobotStands) {
  const MotionSpread spread = cut_step_spread(OdometryMotion(), {}, {});
  EXPECT_EQ(spread.drive_m, 0.0);
  EXPECT_EQ(spread.turn_before_rad, 0.0);
}

}  // namespace
}  // namespace echomap::models
