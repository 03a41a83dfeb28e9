// SPDX-License-Identifier: MIT
#include "firmware/drivers/scalar_sensor.hpp"

#include <gtest/gtest.h>

#include "firmware/boards/native/native_board.hpp"

namespace echomap::drivers {
namespace {

class ScalarSensorTest : public testing::Test {
 protected:
  ScalarSensorTest() {
    board.power_on();
    board.use_aux_pin(0, hal::PinUse::kPulses);
  }
  void pulse(int times) {
    for (int i = 0; i < times; ++i) {
      board.set_aux_level(0, false);
      board.set_aux_level(0, true);
    }
  }

  native::NativeBoard& board = native::NativeBoard::instance();
  ScalarSensor sensor;
};

TEST_F(ScalarSensorTest, SumsUpPulsesBeyondWhatTheBoardCounts) {
  for (int ms = 0; ms < 1000; ++ms) {
    pulse(ms % 2 == 0 ? 199 : 0);
    sensor.tick();
  }
  EXPECT_EQ(sensor.sum(), 500U * 199U);
  EXPECT_EQ(sensor.samples(), 0);
}

TEST_F(ScalarSensorTest, SumsUpConversionsAndCountsThem) {
  for (int i = 0; i < 70000; ++i) {
    sensor.add(1023);
  }
  EXPECT_EQ(sensor.sum(), 70000U * 1023U);
  EXPECT_EQ(sensor.samples(), 70000 % 65536);
}

TEST_F(ScalarSensorTest, GoesOnWhenThePinHasAnotherUse) {
  pulse(5);
  sensor.tick();
  board.use_aux_pin(0, hal::PinUse::kUnused);
  pulse(5);
  sensor.tick();
  board.use_aux_pin(0, hal::PinUse::kPulses);
  pulse(2);
  sensor.tick();
  EXPECT_EQ(sensor.sum(), 7U);
}

}  // namespace
}  // namespace echomap::drivers
