// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>

namespace echomap::emulator {

/// A port letter and the bit in it.
struct Pin {
  char port;
  std::uint8_t bit;
};

/// A timer's compare unit (0 A, 1 B) and the pin that it drives.
struct CompareUnit {
  char timer;
  std::uint8_t unit;
  Pin pin;
};

/// A pin that goes to a motor driver. It has a level, or a compare unit's pulses.
struct DriverPin {
  static constexpr char kNoPort = 0;
  static constexpr char kNoTimer = 0;

  Pin pin{kNoPort, 0};
  char timer = kNoTimer;
  std::uint8_t unit = 0;
};

/// The wires to one half of a driver, as in world::DriverInputs.
struct DriverWires {
  DriverPin pwm;
  DriverPin in1;
  DriverPin in2;
};

/// Those of one motor to each kind of driver, in the order of world::DriverInterface.
using MotorWiring = std::array<DriverWires, 4>;

/// Where the chip has its two-wire interface.
struct TwoWireWiring {
  Pin sda;
  Pin scl;
};

/// A spare pin that protocol::ConfigurePins numbers.
struct SparePin {
  static constexpr char kNoPort = 0;
  static constexpr int kNoChannel = -1;

  Pin pin;      ///< With kNoPort where it only reads voltages.
  int channel;  ///< Of the converter; kNoChannel for none.
};

/// Where the robot's parts are wired to a board: the same table as in docs/hardware and in the
/// board's firmware/boards/*/pins.hpp.
struct BoardWiring {
  const char* board;  ///< As in the name of its image: "uno".
  const char* chip;   ///< As simavr and avr-gcc's -mmcu call it: "atmega328p".
  Pin left_encoder_a;
  Pin left_encoder_b;
  Pin right_encoder_a;
  Pin right_encoder_b;
  Pin sonar_echo;
  Pin sonar_trigger;
  CompareUnit pan_servo;
  MotorWiring left_motor;
  MotorWiring right_motor;
  Pin left_bump;  ///< Low is pressed.
  Pin right_bump;
  TwoWireWiring two_wire;
  std::array<SparePin, 16> spare;
  std::uint8_t spare_count;
};

/// The board that carries `chip`. Throws std::runtime_error, naming those that are known.
const BoardWiring& wiring_of_chip(const std::string& chip);

}  // namespace echomap::emulator
