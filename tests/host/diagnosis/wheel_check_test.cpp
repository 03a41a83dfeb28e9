// SPDX-License-Identifier: MIT
#include "host/diagnosis/wheel_check.hpp"

#include <gtest/gtest.h>

namespace echomap::diagnosis {
namespace {

using exploration::Drive;
using exploration::MotionResult;
using exploration::Sweep;
using exploration::Turn;

TEST(WheelCheck, NamesTheWheelThatTurnsAgainstItsCommand) {
  WheelCheck wheels;
  wheels.begin(Turn{1.0});
  wheels.follow({0.05, 0.04});
  wheels.end(MotionResult::kStalled);
  EXPECT_EQ(wheels.turned_against(), FaultKind::kLeftAgainst);
}

TEST(WheelCheck, NamesBothWheelsWhereTheMotorsAreExchanged) {
  WheelCheck wheels;
  wheels.begin(Turn{1.0});
  wheels.follow({0.05, -0.05});
  wheels.end(MotionResult::kInterrupted);
  EXPECT_EQ(wheels.turned_against(), FaultKind::kBothAgainst);
}

TEST(WheelCheck, NamesTheWheelThatStandsWhileTheOtherOneTurns) {
  WheelCheck wheels;
  wheels.begin(Drive{-0.5});
  wheels.follow({-0.1, 0.0});
  wheels.end(MotionResult::kStalled);
  EXPECT_EQ(wheels.stood_still(), FaultKind::kRightStands);
  EXPECT_FALSE(wheels.turned_against());
}

TEST(WheelCheck, SaysNothingOfAWheelThatIsTurnedByHand) {
  WheelCheck wheels;
  wheels.begin(Drive{0.5});
  wheels.follow({0.1, -0.1});
  wheels.end(MotionResult::kLifted);
  EXPECT_FALSE(wheels.turned_against());
  wheels.lift();
  wheels.begin(Drive{0.5});
  wheels.follow({0.0, -0.2});
  wheels.end(MotionResult::kInterrupted);
  EXPECT_FALSE(wheels.turned_against());
}

TEST(WheelCheck, AccusesNobodyOfWhatWasReachedOrHeldBoth) {
  WheelCheck wheels;
  wheels.begin(Drive{0.5});
  wheels.follow({0.5, 0.5});
  wheels.end(MotionResult::kReached);
  wheels.begin(Drive{0.5});
  wheels.end(MotionResult::kStalled);
  wheels.begin(Sweep{});
  wheels.follow({0.3, 0.3});
  wheels.end(MotionResult::kStalled);
  EXPECT_FALSE(wheels.turned_against());
  EXPECT_FALSE(wheels.stood_still());
}

}  // namespace
}  // namespace echomap::diagnosis
