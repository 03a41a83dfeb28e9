// SPDX-License-Identifier: MIT
#include "hil_mock/world/stepper_motor.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/hil_mock/world/steps.hpp"

namespace echomap::world {
namespace {

/// A, AB, B, BC, C, CD, D, DA.
constexpr std::array<Coils, 8> kHalfSteps = {{{true, false, false, false},
                                              {true, true, false, false},
                                              {false, true, false, false},
                                              {false, true, true, false},
                                              {false, false, true, false},
                                              {false, false, true, true},
                                              {false, false, false, true},
                                              {true, false, false, true}}};

/// Makes `count` half steps, one each `period_ms`; negative ones backwards.
void drive(StepperMotor& motor, int count, int period_ms, int from = 0) {
  for (int i = 1; i <= std::abs(count); ++i) {
    const int pattern = (from + (count < 0 ? -i : i)) & 7;
    for (int ms = 0; ms < period_ms; ++ms) {
      motor.step(kStepS, kHalfSteps.at(static_cast<std::size_t>(pattern)));
    }
  }
}

TEST(StepperMotor, TurnsTwiceAndBack) {
  StepperMotor motor({});
  const int two_turns = 2 * 4076;
  drive(motor, two_turns, 2);
  EXPECT_NEAR(motor.half_steps(), two_turns, 1e-9);
  EXPECT_NEAR(motor.pan_rad(), 4.0 * std::numbers::pi, 1e-3);
  drive(motor, -two_turns, 2, two_turns);
  EXPECT_NEAR(motor.pan_rad(), 0.0, 1e-9);
}

TEST(StepperMotor, TurnsRightWhereItsCoilsAreSwapped) {
  StepperMotor motor({-4075.77, 600.0});
  drive(motor, 1019, 2);
  EXPECT_NEAR(motor.pan_rad(), -0.5 * std::numbers::pi, 1e-3);
}

TEST(StepperMotor, LosesStepsByEightAboveItsSpeed) {
  StepperMotor motor({});
  drive(motor, 800, 1);
  drive(motor, 8, 20, 800);
  const double lost = 808.0 - motor.half_steps();
  EXPECT_GT(lost, 300.0);
  EXPECT_NEAR(std::remainder(lost, 8.0), 0.0, 1e-9);
}

TEST(StepperMotor, WithoutCurrentItsGearHoldsIt) {
  StepperMotor motor({});
  drive(motor, 100, 2);
  const double pan_rad = motor.pan_rad();
  for (int i = 0; i < 100; ++i) {
    motor.step(kStepS, {});
    motor.step(kStepS, {true, false, true, false});
  }
  EXPECT_EQ(motor.pan_rad(), pan_rad);
}

TEST(StepperMotor, RefusesAMotorThatIsNone) {
  EXPECT_THROW(StepperMotor({0.0, 600.0}), std::invalid_argument);
  EXPECT_THROW(StepperMotor({4076.0, 0.0}), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::world
