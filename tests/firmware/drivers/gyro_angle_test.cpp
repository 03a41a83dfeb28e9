// SPDX-License-Identifier: MIT
#include "firmware/drivers/gyro_angle.hpp"

#include <gtest/gtest.h>

#include "firmware/boards/native/native_board.hpp"
#include "firmware/drivers/gyro.hpp"

namespace echomap::drivers {
namespace {

/// Period 10 ms, range 1: 32768 counts are 500 degrees a second.
class GyroAngleTest : public testing::Test {
 protected:
  GyroAngleTest() { board.has_yaw_gyro = true; }
  ~GyroAngleTest() override {
    board.has_yaw_gyro = false;
    board.yaw_deg.reset();
  }

  void run_ms(int ms) {
    for (int i = 0; i < ms; ++i) {
      gyro.tick(settings);
    }
  }
  double turned_deg() const { return gyro.yaw_sum() * (500.0 / 32768) * 0.010; }

  native::NativeBoard& board = native::NativeBoard::instance();
  protocol::ConfigureSensors settings{0, 0, 10, 1};
  GyroAngle gyro;
};

TEST_F(GyroAngleTest, SumOfSamplesIsTheTurnSinceTheFirst) {
  board.yaw_deg = 70;
  run_ms(10);
  EXPECT_EQ(gyro.yaw_sum(), 0);
  for (int deg = 71; deg <= 430; ++deg) {
    board.yaw_deg = static_cast<std::int16_t>(deg);
    run_ms(10);
  }
  EXPECT_NEAR(turned_deg(), 360.0, 0.1);
  EXPECT_EQ(gyro.samples(), 361);
  EXPECT_EQ(gyro.errors(), 0);
}

TEST_F(GyroAngleTest, DegreesThatAreNoWholeCountsAddUp) {
  settings.gyro_range = 3;  // A degree is 1638.4 counts.
  board.yaw_deg = 0;
  run_ms(10);
  for (const int direction : {1, -1}) {
    for (int deg = 1; deg <= 360; ++deg) {
      board.yaw_deg = static_cast<std::int16_t>(direction > 0 ? deg : 360 - deg);
      run_ms(10);
    }
    EXPECT_EQ(gyro.yaw_sum(), direction > 0 ? 589824 : 0);
  }
}

TEST_F(GyroAngleTest, GoesOnAcrossTheEndOfSixteenBits) {
  board.yaw_deg = INT16_MAX;
  run_ms(10);
  board.yaw_deg = INT16_MIN;
  run_ms(10);
  EXPECT_NEAR(turned_deg(), 1.0, 0.01);
}

TEST_F(GyroAngleTest, SilentGyroCountsErrorsAndLosesNoTurn) {
  board.yaw_deg = 0;
  run_ms(10);
  board.yaw_deg.reset();
  run_ms(20);
  EXPECT_EQ(gyro.errors(), 2);
  board.yaw_deg = -9;
  run_ms(10);
  EXPECT_NEAR(turned_deg(), -9.0, 0.01);
}

TEST_F(GyroAngleTest, RestsWithoutAPeriodAndBeginsAnewWithOne) {
  board.yaw_deg = 0;
  run_ms(10);
  settings.gyro_period_ms = 0;
  gyro.restart();
  board.yaw_deg = 90;
  run_ms(100);
  EXPECT_EQ(gyro.samples(), 1);
  settings.gyro_period_ms = 5;
  run_ms(10);
  EXPECT_EQ(gyro.samples(), 3);
  EXPECT_EQ(gyro.yaw_sum(), 0);
}

TEST_F(GyroAngleTest, GyroOfABoardThatHasOneNeedsNoBus) {
  EXPECT_TRUE(Gyro::can_be());
  EXPECT_FALSE(Gyro::needs_twi());
  board.has_yaw_gyro = false;
  EXPECT_TRUE(Gyro::needs_twi());
}

}  // namespace
}  // namespace echomap::drivers
