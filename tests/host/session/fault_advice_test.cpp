// SPDX-License-Identifier: MIT
#include "host/session/fault_advice.hpp"

#include <numbers>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "protocol/command_messages.hpp"

namespace echomap::session {
namespace {

using diagnosis::Fault;
using diagnosis::FaultKind;
using ::testing::HasSubstr;

constexpr double kSevenDegreesRad = 7.0 / 180.0 * std::numbers::pi;

/// A fault of uno_2wd, and words of what is said of it.
struct AdvisedFault {
  Fault fault;
  std::string what;
  std::string change;
};

void expect_advice(const std::vector<AdvisedFault>& faults) {
  const RobotProfile profile = load_robot_profile("uno_2wd");
  for (const AdvisedFault& expected : faults) {
    const FaultAdvice advice = advice_of(expected.fault, profile);
    EXPECT_THAT(advice.what, HasSubstr(expected.what));
    EXPECT_THAT(advice.change, HasSubstr(expected.change));
  }
}

TEST(FaultAdvice, SaysTheNumberThatTheProfileShouldHold) {
  expect_advice(
      {{{FaultKind::kLeftWheelSize, 1.08},
        "the left wheel rolls 8 % farther than the profile says",
        "set left_wheel_scale = 1.080 in [drive] of the profile"},
       {{FaultKind::kRightWheelSize, 0.95},
        "the right wheel rolls 5 % less far than",
        "right_wheel_scale = 0.950"},
       {{FaultKind::kWheelSize, 1.08}, "both wheels roll 8 % farther", "wheel_diameter_m = 0.0702"},
       {{FaultKind::kLeftCounts, 0.5}, "the left encoder gives 0.50 times", "left_wheel_scale = 2"},
       {{FaultKind::kRightCounts, 2.0},
        "the right encoder gives 2.00 times",
        "right_wheel_scale = 0.5"},
       {{FaultKind::kCounts, 0.5}, "the encoders give 0.50 times", "counts_per_turn = 748 in"},
       {{FaultKind::kRangeScale, 0.909},
        "ranges are 10 % too long",
        "set range_scale = 0.909 in [sonar]"},
       {{FaultKind::kRangeScale, 1.25}, "ranges are 20 % too short", "range_scale = 1.25"}});
}

TEST(FaultAdvice, MendsThePan) {
  expect_advice({{{FaultKind::kPanReversed, 0.0},
                  "the pan turns the other way",
                  "set us_per_90deg = -900 in [pan]"},
                 {{FaultKind::kPanOffset, kSevenDegreesRad},
                  "looks 7 degrees to the left",
                  "set centre_us = 1430 in [pan]"},
                 {{FaultKind::kPanOffset, -kSevenDegreesRad},
                  "looks 7 degrees to the right",
                  "centre_us = 1570"}});
  const RobotProfile stepper = load_robot_profile("ev3_mega");
  EXPECT_THAT(advice_of({FaultKind::kPanReversed, 0.0}, stepper).change,
              HasSubstr("half_steps_per_turn = -4076"));
  EXPECT_THAT(advice_of({FaultKind::kPanOffset, kSevenDegreesRad}, stepper).change,
              HasSubstr("point it straight ahead"));
}

TEST(FaultAdvice, MendsTheWiresOfTheWheels) {
  expect_advice({{{FaultKind::kLeftReversed, 0.0},
                  "the left wheel goes backwards",
                  "set invert_left_motor = true and invert_left_encoder = true"},
                 {{FaultKind::kRightReversed, 0.0},
                  "the right wheel goes backwards",
                  "set invert_right_motor = true and invert_right_encoder = true"},
                 {{FaultKind::kBothReversed, 0.0}, "both wheels go backwards", "invert_left_motor"},
                 {{FaultKind::kBothReversed, 0.0}, "both wheels", "invert_right_motor = true"},
                 {{FaultKind::kNotMoving, 0.0}, "the robot stays where it is", "on the floor"},
                 {{FaultKind::kLeftAgainst, 0.0},
                  "the left wheel counts backwards",
                  "change invert_left_motor, else invert_left_encoder"},
                 {{FaultKind::kRightAgainst, 0.0},
                  "the right wheel counts backwards",
                  "change invert_right_motor, else invert_right_encoder"},
                 {{FaultKind::kBothAgainst, 0.0},
                  "both wheels count against their commands",
                  "exchange the plugs of the encoders, else those of the motors"},
                 {{FaultKind::kLeftStands, 0.0},
                  "the left wheel does not turn",
                  "check the wires of the left motor and encoder"},
                 {{FaultKind::kRightStands, 0.0},
                  "the right wheel does not turn",
                  "check the wires of the right motor and encoder"},
                 {{FaultKind::kLeftDirty, 0.021},
                  "the left encoder loses 2.1 % of its counts",
                  "clean the left encoder's disc"},
                 {{FaultKind::kRightDirty, 0.021},
                  "the right encoder loses 2.1 %",
                  "the supply of the right encoder"}});
}

TEST(FaultAdvice, GoesByWhatTheProfileHoldsNow) {
  RobotProfile profile = load_robot_profile("uno_2wd");
  profile.configuration.drive.inversions =
      protocol::kInvertLeftMotor | protocol::kInvertLeftEncoder;
  profile.geometry.left_wheel_scale = 0.5;
  profile.range_scale = 1.1;
  EXPECT_THAT(advice_of({FaultKind::kLeftReversed, 0.0}, profile).change,
              HasSubstr("invert_left_motor = false and invert_left_encoder = false"));
  EXPECT_THAT(advice_of({FaultKind::kLeftWheelSize, 1.08}, profile).change,
              HasSubstr("left_wheel_scale = 0.540"));
  EXPECT_THAT(advice_of({FaultKind::kRangeScale, 0.9}, profile).change,
              HasSubstr("range_scale = 0.990"));
}

TEST(FaultAdvice, HasWordsForEveryFaultAndNoneForNone) {
  const RobotProfile profile = load_robot_profile("uno_2wd");
  EXPECT_EQ(advice_of({}, profile).what, "");
  constexpr auto kLast = static_cast<int>(FaultKind::kRightDirty);
  for (int kind = static_cast<int>(FaultKind::kNone) + 1; kind <= kLast; ++kind) {
    const FaultAdvice advice = advice_of({static_cast<FaultKind>(kind), 1.08}, profile);
    EXPECT_NE(advice.what, "") << kind;
    EXPECT_NE(advice.change, "") << kind;
  }
}

}  // namespace
}  // namespace echomap::session
