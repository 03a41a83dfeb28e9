// SPDX-License-Identifier: MIT
#include "firmware/control/driven_wheel.hpp"

#include <gtest/gtest.h>

#include "firmware/app/settings.hpp"
#include "firmware/boards/native/native_board.hpp"
#include "firmware/control/fixed_point.hpp"

namespace echomap::control {
namespace {

int pin_duty() { return native::NativeBoard::instance().right_duty(); }

TEST(DrivenWheel, CountsFromWhereItBegan) {
  DrivenWheel wheel(hal::Motor::kRight);
  wheel.begin(32767);
  wheel.prepare(app::kDefaultDrive, 0);
  wheel.follow(32767);
  EXPECT_EQ(pin_duty(), 0);
  EXPECT_TRUE(wheel.arrived());
}

TEST(DrivenWheel, FollowsAcrossTheWrapOfTheCounter) {
  DrivenWheel wheel(hal::Motor::kRight);
  wheel.begin(32760);
  wheel.prepare(app::kDefaultDrive, 10 * kOneTick);
  wheel.follow(-32766);
  for (int i = 0; i <= WheelSpeedController::kStillPeriods; ++i) {
    wheel.prepare(app::kDefaultDrive, 0);
    wheel.follow(-32766);
  }
  EXPECT_TRUE(wheel.arrived());
  wheel.release();
}

TEST(DrivenWheel, PushesTowardsItsReferenceUntilReleased) {
  DrivenWheel wheel(hal::Motor::kRight);
  wheel.begin(0);
  wheel.prepare(app::kDefaultDrive, per_period(1000));
  wheel.follow(0);
  EXPECT_GT(pin_duty(), 0);
  wheel.release();
  EXPECT_EQ(pin_duty(), 0);
}

}  // namespace
}  // namespace echomap::control
