// SPDX-License-Identifier: MIT
#include "firmware/drivers/analog_inputs.hpp"

#include <gtest/gtest.h>

#include "firmware/boards/native/native_board.hpp"
#include "protocol/telemetry_messages.hpp"

namespace echomap::drivers {
namespace {

class AnalogInputsTest : public testing::Test {
 protected:
  AnalogInputsTest() {
    board.power_on();
    configure({});
  }
  void configure(const protocol::ConfigurePins& wanted) {
    pins.configure(wanted);
    inputs.reset();
  }
  void run_ms(int ms) {
    for (int i = 0; i < ms; ++i) {
      board.run_until_ns(board.now_ns() + 1000000);
      inputs.tick(pins, scalar);
    }
  }

  std::uint16_t range(std::uint8_t channel) const { return inputs.range(channel); }

  native::NativeBoard& board = native::NativeBoard::instance();
  protocol::ConfigurePins active{};
  SparePins pins{active};
  AnalogInputs inputs;
  ScalarSensor scalar;
};

TEST_F(AnalogInputsTest, NothingIsReadWithoutAPin) {
  run_ms(20);
  for (std::uint8_t channel = 0; channel < 8; ++channel) {
    EXPECT_EQ(range(channel), protocol::kNoRange);
  }
  EXPECT_EQ(inputs.battery(), 0);
}

TEST_F(AnalogInputsTest, EveryInputIsReadInAMillisecondAnInput) {
  protocol::ConfigurePins wanted{};
  wanted.pin_0 = protocol::kPinRange0 + 2;
  wanted.pin_3 = protocol::kPinCliffLeft;
  wanted.pin_5 = protocol::kPinRange0;
  wanted.pin_6 = protocol::kPinBattery;
  wanted.pin_15 = protocol::kPinWheelDrop;
  configure(wanted);
  run_ms(20);
  for (std::uint16_t raw = 100; raw < 1000; raw = static_cast<std::uint16_t>(raw + 37)) {
    board.set_aux_analog(0, raw);
    board.set_aux_analog(5, static_cast<std::uint16_t>(raw + 1));
    board.set_aux_analog(6, static_cast<std::uint16_t>(raw + 2));
    run_ms(3 + 1);  // The conversion under way is an old one.
    EXPECT_EQ(range(2), raw);
    EXPECT_EQ(range(0), raw + 1);
    EXPECT_EQ(inputs.battery(), raw + 2);
    EXPECT_EQ(range(1), protocol::kNoRange);
  }
}

TEST_F(AnalogInputsTest, ScalarSensorGetsEveryConversionOfItsPin) {
  protocol::ConfigurePins wanted{};
  wanted.pin_1 = protocol::kPinScalarLevel;
  wanted.pin_2 = protocol::kPinBattery;
  configure(wanted);
  board.set_aux_analog(1, 1000);
  board.set_aux_analog(2, 3);
  run_ms(1 + 100 * 2);
  EXPECT_EQ(scalar.samples(), 100);
  EXPECT_EQ(scalar.sum(), 100 * 1000U);
  EXPECT_EQ(inputs.battery(), 3);
  board.set_aux_analog(1, 500);
  run_ms(1 + 100 * 2);
  EXPECT_NEAR(scalar.sum(), 150'500, 500) << "it sums up, whoever reads it";
}

TEST_F(AnalogInputsTest, ChannelThatLosesItsPinSaysSo) {
  protocol::ConfigurePins wanted{};
  wanted.pin_3 = protocol::kPinRange0 + 4;
  configure(wanted);
  board.set_aux_analog(3, 512);
  run_ms(20);
  EXPECT_EQ(range(4), 512);
  configure({});
  run_ms(20);
  EXPECT_EQ(range(4), protocol::kNoRange);
}

}  // namespace
}  // namespace echomap::drivers
