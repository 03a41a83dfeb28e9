// SPDX-License-Identifier: GPL-3.0-or-later
#include "hil_mock/emulator/board_wiring.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace echomap::emulator {
namespace {

constexpr std::uint8_t kA = 0;
constexpr std::uint8_t kB = 1;

/// A spare pin that is also a channel of the converter, or none.
constexpr SparePin spare(char port, std::uint8_t bit, int channel = SparePin::kNoChannel) {
  return {{port, bit}, channel};
}

/// A spare pin that only reads voltages.
constexpr SparePin voltage(int channel) { return {{SparePin::kNoPort, 0}, channel}; }

/// A pin that a program can only set.
constexpr DriverPin port_pin(char port, std::uint8_t bit) { return {{port, bit}}; }

constexpr DriverPin pwm_pin(char timer, std::uint8_t unit, char port, std::uint8_t bit) {
  return {{port, bit}, timer, unit};
}

constexpr DriverPin kNoPin{};

namespace uno {
constexpr DriverPin kD4 = port_pin('D', 4);
constexpr DriverPin kD5 = pwm_pin('0', kB, 'D', 5);
constexpr DriverPin kD6 = pwm_pin('0', kA, 'D', 6);
constexpr DriverPin kD7 = port_pin('D', 7);
constexpr DriverPin kD11 = port_pin('B', 3);
constexpr DriverPin kD12 = port_pin('B', 4);
}  // namespace uno

namespace mega {
constexpr DriverPin kD4 = pwm_pin('0', kB, 'G', 5);
constexpr DriverPin kD5 = pwm_pin('3', kA, 'E', 3);
constexpr DriverPin kD6 = pwm_pin('4', kA, 'H', 3);
constexpr DriverPin kD7 = pwm_pin('4', kB, 'H', 4);
constexpr DriverPin kD8 = port_pin('H', 5);
constexpr DriverPin kD9 = port_pin('H', 6);
constexpr DriverPin kD11 = pwm_pin('1', kA, 'B', 5);
constexpr DriverPin kD12 = pwm_pin('1', kB, 'B', 6);
}  // namespace mega

/// Has no timer left for servos.
constexpr BoardWiring kUno{
    .board = "uno",
    .chip = "atmega328p",
    .left_encoder_a = {'C', 0},
    .left_encoder_b = {'C', 1},
    .right_encoder_a = {'C', 2},
    .right_encoder_b = {'C', 3},
    .sonar_echo = {'B', 0},  // ICP1
    .sonar_trigger = {'B', 1},
    .pan_servo = {'1', kB, {'B', 2}},
    .left_motor = {{{uno::kD6, uno::kD4, kNoPin},
                    {uno::kD6, uno::kD4, uno::kD11},
                    {kNoPin, uno::kD6, uno::kD4},
                    {}}},
    .right_motor = {{{uno::kD5, uno::kD7, kNoPin},
                     {uno::kD5, uno::kD7, uno::kD12},
                     {kNoPin, uno::kD5, uno::kD7},
                     {}}},
    .left_bump = {'D', 2},
    .right_bump = {'D', 3},
    .two_wire = {{'C', 4}, {'C', 5}},
    // D11 .. D13, A4, A5, A6, A7
    .spare = {spare('B', 3),
              spare('B', 4),
              spare('B', 5),
              spare('C', 4, 4),
              spare('C', 5, 5),
              voltage(6),
              voltage(7)},
    .spare_count = 7,
};

/// Motors and contacts have the same Arduino names as on the Uno.
constexpr BoardWiring kMega{
    .board = "mega",
    .chip = "atmega2560",
    .left_encoder_a = {'B', 0},
    .left_encoder_b = {'B', 1},
    .right_encoder_a = {'B', 2},
    .right_encoder_b = {'B', 3},
    .sonar_echo = {'L', 1},  // ICP5
    .sonar_trigger = {'L', 3},
    .pan_servo = {'5', kB, {'L', 4}},
    .left_motor = {{{mega::kD6, mega::kD4, kNoPin},
                    {mega::kD6, mega::kD4, mega::kD8},
                    {kNoPin, mega::kD6, mega::kD4},
                    {mega::kD11, kNoPin, kNoPin}}},
    .right_motor = {{{mega::kD5, mega::kD7, kNoPin},
                     {mega::kD5, mega::kD7, mega::kD9},
                     {kNoPin, mega::kD5, mega::kD7},
                     {mega::kD12, kNoPin, kNoPin}}},
    .left_bump = {'E', 4},
    .right_bump = {'E', 5},
    .two_wire = {{'D', 1}, {'D', 0}},
    // D22 .. D29, A8 .. A15
    .spare = {spare('A', 0),
              spare('A', 1),
              spare('A', 2),
              spare('A', 3),
              spare('A', 4),
              spare('A', 5),
              spare('A', 6),
              spare('A', 7),
              spare('K', 0, 8),
              spare('K', 1, 9),
              spare('K', 2, 10),
              spare('K', 3, 11),
              spare('K', 4, 12),
              spare('K', 5, 13),
              spare('K', 6, 14),
              spare('K', 7, 15)},
    .spare_count = 16,
};

constexpr std::array kBoards{kUno, kMega};

}  // namespace

const BoardWiring& wiring_of_chip(const std::string& chip) {
  const auto found = std::find_if(kBoards.begin(), kBoards.end(), [&](const BoardWiring& wiring) {
    return wiring.chip == chip;
  });
  if (found != kBoards.end()) {
    return *found;
  }
  std::string known;
  for (const BoardWiring& wiring : kBoards) {
    known += (known.empty() ? "" : ", ") + std::string(wiring.board) + " (" + wiring.chip + ")";
  }
  throw std::runtime_error("no board here carries an " + chip + "; known: " + known);
}

}  // namespace echomap::emulator
