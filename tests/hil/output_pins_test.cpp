// SPDX-License-Identifier: MIT
/// What an emulated chip's registers make of its pins, by writing the registers by hand.
#include "hil_mock/emulator/output_pins.hpp"

#include <cstdint>
#include <string>

#include <gtest/gtest.h>

#include "hil_mock/emulator/chip_modules.hpp"
#include "hil_mock/emulator/simavr_board.hpp"

namespace echomap::emulator {
namespace {

using runner::Wheel;
using world::DriverInputs;
using world::DriverInterface;

class Registers {
 public:
  explicit Registers(const std::string& chip) : board(ECHOMAP_PROBE + chip + ".elf") {}

  /// Makes the pin an output, or an input with `high` for its pull-up.
  void set_pin(Pin pin, bool output, bool high) {
    const avr_ioport_t& port = find_port(core(), pin.port);
    set_bit(port.r_ddr, pin.bit, output);
    set_bit(port.r_port, pin.bit, high);
  }

  /// TCCRnA, TCCRnB and the compare register of unit A (0) or B.
  void set_timer(char name, unsigned unit, unsigned a, unsigned b, unsigned compare) {
    const avr_timer_t& timer = find_timer(core(), name);
    write(static_cast<std::uint16_t>(timer.comp[0].com.reg), a);
    write(static_cast<std::uint16_t>(timer.cs[0].reg), b);
    const avr_timer_comp_t& match = timer.comp[unit];
    if (match.r_ocrh != 0) {
      write(match.r_ocrh, compare >> 8);
    }
    write(match.r_ocr, compare & 0xFF);
  }

  void set_top(char name, unsigned top) {
    write(find_timer(core(), name).r_icrh, top >> 8);
    write(find_timer(core(), name).r_icr, top & 0xFF);
  }

  DriverInputs left(DriverInterface interface) const {
    return board.driver_inputs(Wheel::kLeft, interface);
  }
  DriverInputs right(DriverInterface interface) const {
    return board.driver_inputs(Wheel::kRight, interface);
  }

  SimavrBoard board;

 private:
  avr_t& core() { return board.machine().core(); }
  void write(std::uint16_t address, unsigned value) {
    core().data[address] = static_cast<std::uint8_t>(value);
  }
  void set_bit(std::uint16_t address, std::uint8_t bit, bool one) {
    const unsigned others = core().data[address] & ~(1U << bit);
    write(address, others | (one ? 1U << bit : 0U));
  }
};

constexpr Pin kUnoD4{'D', 4};
constexpr Pin kUnoD6{'D', 6};
constexpr Pin kUnoD11{'B', 3};
constexpr unsigned kClearAtMatchA = 0x80;
constexpr unsigned kSetAtMatchA = 0xC0;
constexpr unsigned kFastPwm = 0x03;
constexpr unsigned kDividedBy8 = 2;
constexpr unsigned kDividedBy64 = 3;

TEST(OutputPins, FloatAfterAReset) {
  for (const char* chip : {"atmega328p", "atmega2560"}) {
    const Registers registers{chip};
    for (const auto interface : {DriverInterface::kPhaseEnable,
                                 DriverInterface::kIn1In2Pwm,
                                 DriverInterface::kTwoPwm,
                                 DriverInterface::kServo}) {
      EXPECT_EQ(registers.left(interface), DriverInputs{}) << chip;
      EXPECT_EQ(registers.right(interface), DriverInputs{}) << chip;
    }
  }
}

TEST(OutputPins, HaveLevelsAndPullUps) {
  Registers registers("atmega328p");
  registers.set_pin(kUnoD6, true, true);
  registers.set_pin(kUnoD4, false, true);
  registers.set_pin(kUnoD11, true, false);
  const DriverInputs inputs = registers.left(DriverInterface::kIn1In2Pwm);
  EXPECT_EQ(inputs.pwm, world::level(true));
  EXPECT_EQ(inputs.in1, world::pulled_up());
  EXPECT_EQ(inputs.in2, world::level(false));
}

TEST(OutputPins, HavePulsesOfATimerThatIsConnected) {
  Registers registers("atmega328p");
  registers.set_pin(kUnoD6, true, false);
  registers.set_timer('0', 0, kClearAtMatchA | kFastPwm, kDividedBy8, 63);
  EXPECT_EQ(registers.left(DriverInterface::kPhaseEnable).pwm, world::pulses(0.25, 128.0));
  registers.set_timer('0', 0, kClearAtMatchA | kFastPwm, kDividedBy64, 63);
  EXPECT_EQ(registers.left(DriverInterface::kTwoPwm).in1, world::pulses(0.25, 1024.0));
  registers.set_timer('0', 0, kSetAtMatchA | kFastPwm, kDividedBy8, 63);
  EXPECT_EQ(registers.left(DriverInterface::kTwoPwm).in1, world::inverted_pulses(0.25, 128.0));
  registers.set_timer('0', 0, kFastPwm, kDividedBy8, 63);
  EXPECT_EQ(registers.left(DriverInterface::kTwoPwm).in1, world::level(false)) << "disconnected";
}

TEST(OutputPins, OfTheUnoHaveNoServo) {
  Registers registers("atmega328p");
  registers.set_pin(kUnoD6, true, true);
  EXPECT_EQ(registers.left(DriverInterface::kServo), DriverInputs{});
}

TEST(OutputPins, OfTheMegaHaveFourPwms) {
  Registers registers("atmega2560");
  constexpr unsigned kClearAtMatchB = 0x20;
  constexpr unsigned kFast8 = 0x01;
  constexpr unsigned kFast8AndDividedBy8 = 0x0A;
  registers.set_pin({'G', 5}, true, false);
  registers.set_pin({'H', 4}, true, false);
  registers.set_timer('0', 1, kClearAtMatchB | kFastPwm, kDividedBy8, 127);
  registers.set_timer('4', 1, kClearAtMatchB | kFast8, kFast8AndDividedBy8, 191);
  EXPECT_EQ(registers.left(DriverInterface::kTwoPwm).in2, world::pulses(0.5, 128.0));
  EXPECT_EQ(registers.right(DriverInterface::kTwoPwm).in2, world::pulses(0.75, 128.0));
}

TEST(OutputPins, OfTheMegaHaveServoPulsesOfTimer1) {
  Registers registers("atmega2560");
  constexpr unsigned kBothClearedMode14 = 0xA2;
  constexpr unsigned kMode14AndDividedBy8 = 0x1A;
  registers.set_pin({'B', 5}, true, false);
  registers.set_pin({'B', 6}, true, false);
  registers.set_top('1', 39'999);
  registers.set_timer('1', 0, kBothClearedMode14, kMode14AndDividedBy8, 3999);
  registers.set_timer('1', 1, kBothClearedMode14, kMode14AndDividedBy8, 2199);
  const world::MotorDriver servo(world::DriverChip::kServo);
  EXPECT_EQ(registers.left(DriverInterface::kServo).pwm, world::pulses(0.1, 20'000.0));
  EXPECT_NEAR(servo.drive(registers.left(DriverInterface::kServo)).duty, 1.0, 1e-9);
  EXPECT_NEAR(servo.drive(registers.right(DriverInterface::kServo)).duty, -0.8, 1e-9);
}

}  // namespace
}  // namespace echomap::emulator
