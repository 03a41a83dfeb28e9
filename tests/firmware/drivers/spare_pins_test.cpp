// SPDX-License-Identifier: MIT
#include "firmware/drivers/spare_pins.hpp"

#include <gtest/gtest.h>

#include "firmware/boards/native/native_board.hpp"
#include "protocol/telemetry_messages.hpp"

namespace echomap::drivers {
namespace {

using hal::PinUse;

class SparePinsTest : public testing::Test {
 protected:
  SparePinsTest() {
    board.power_on();
    for (std::uint8_t pin = 0; pin < native::NativeBoard::kAuxPins; ++pin) {
      board.set_aux_level(pin, true);
    }
  }
  ~SparePinsTest() override { board.set_aux_level(2, true); }

  native::NativeBoard& board = native::NativeBoard::instance();
  protocol::ConfigurePins active{};
  protocol::ConfigurePins wanted{};
  SparePins pins{active};
};

TEST_F(SparePinsTest, EachFunctionHasItsUse) {
  wanted.pin_1 = protocol::kPinCliffLeft;
  wanted.pin_2 = protocol::kPinWall | protocol::kPinActiveHigh;
  wanted.pin_3 = protocol::kPinBattery;
  wanted.pin_4 = protocol::kPinRange0;
  wanted.pin_5 = protocol::kPinRange0 + 7;
  wanted.pin_6 = protocol::kPinScalarLevel;
  wanted.pin_7 = protocol::kPinScalarPulses;
  wanted.pin_15 = protocol::kPinStepperPhaseA + 3;
  ASSERT_TRUE(pins.accepts(wanted));
  pins.configure(wanted);
  const PinUse expected[] = {PinUse::kUnused,
                             PinUse::kDigital,
                             PinUse::kDigital,
                             PinUse::kAnalog,
                             PinUse::kAnalog,
                             PinUse::kAnalog,
                             PinUse::kAnalog,
                             PinUse::kPulses};
  for (std::uint8_t pin = 0; pin < 8; ++pin) {
    EXPECT_EQ(board.aux_use(pin), expected[pin]) << int{pin};
  }
  EXPECT_EQ(board.aux_use(15), PinUse::kOutput);
  EXPECT_EQ(pins.used(), 16);
  EXPECT_EQ(pins.function(5), protocol::kPinRange0 + 7);
  pins.configure({});
  EXPECT_EQ(pins.used(), 0);
  EXPECT_EQ(board.aux_use(15), PinUse::kUnused);
}

TEST_F(SparePinsTest, AcceptsEveryFunctionThatThereIsAndNoOther) {
  for (int function = 0; function < 256; ++function) {
    const int plain = function & 0x7F;
    const bool exists = (plain >= 1 && plain <= 7) || function == 0 ||
                        (function >= 8 && function <= 10) || (function >= 16 && function <= 23) ||
                        (function >= 32 && function <= 35);
    wanted.pin_9 = static_cast<std::uint8_t>(function);
    EXPECT_EQ(pins.accepts(wanted), exists) << function;
  }
}

TEST_F(SparePinsTest, HazardsAreActiveLowUnlessSaidOtherwise) {
  wanted.pin_2 = protocol::kPinCliffFrontRight;
  wanted.pin_3 = protocol::kPinWheelDrop | protocol::kPinActiveHigh;
  pins.configure(wanted);
  EXPECT_EQ(pins.active_hazards(), protocol::kHazardWheelDrop);
  board.set_aux_level(2, false);
  board.set_aux_level(3, false);
  EXPECT_EQ(pins.active_hazards(), protocol::kHazardCliffFrontRight);
}

TEST_F(SparePinsTest, EveryDigitalFunctionIsItsBit) {
  for (std::uint8_t function = protocol::kPinCliffLeft; function <= protocol::kPinWall;
       ++function) {
    wanted.pin_2 = function;
    pins.configure(wanted);
    board.set_aux_level(2, false);
    EXPECT_EQ(pins.active_hazards(), 1U << (function - 1)) << int{function};
    board.set_aux_level(2, true);
    EXPECT_EQ(pins.active_hazards(), 0U) << int{function};
  }
}

TEST_F(SparePinsTest, ABridgeTakesPinsThatNobodyUsesAndGivesThemBack) {
  wanted.pin_1 = protocol::kPinCliffLeft;
  wanted.pin_2 = protocol::kPinWall;
  pins.configure(wanted);
  EXPECT_FALSE(pins.can_take(0b011));
  EXPECT_TRUE(pins.can_take(0b1001));
  wanted.pin_1 = protocol::kPinUnused;
  pins.configure(wanted);
  ASSERT_TRUE(pins.can_take(0b011));
  pins.take(0b011);
  hal::use_aux_pin(0, PinUse::kOutput);  // As a board's bridge.
  EXPECT_TRUE(pins.accepts(wanted));
  pins.configure(wanted);
  EXPECT_EQ(board.aux_use(0), PinUse::kOutput) << "the bridge's";
  wanted.pin_0 = protocol::kPinCliffLeft;
  EXPECT_FALSE(pins.accepts(wanted));
  pins.take(0);
  EXPECT_EQ(board.aux_use(0), PinUse::kUnused);
  EXPECT_TRUE(pins.accepts(wanted));
}

TEST_F(SparePinsTest, StepperNeedsAllFourPhases) {
  wanted.pin_0 = protocol::kPinStepperPhaseA;
  wanted.pin_1 = protocol::kPinStepperPhaseA + 1;
  wanted.pin_2 = protocol::kPinStepperPhaseA + 2;
  pins.configure(wanted);
  EXPECT_FALSE(pins.has_stepper());
  wanted.pin_7 = protocol::kPinStepperPhaseA + 3;
  pins.configure(wanted);
  EXPECT_TRUE(pins.has_stepper());
  pins.set_stepper_phases(0b1001);
  EXPECT_TRUE(board.aux_output(0));
  EXPECT_FALSE(board.aux_output(1));
  EXPECT_FALSE(board.aux_output(2));
  EXPECT_TRUE(board.aux_output(7));
}

}  // namespace
}  // namespace echomap::drivers
