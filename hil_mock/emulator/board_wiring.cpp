// SPDX-License-Identifier: GPL-3.0-or-later
#include "hil_mock/emulator/board_wiring.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace echomap::emulator {
namespace {

constexpr std::uint8_t kA = 0;
constexpr std::uint8_t kB = 1;

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
    .left_motor = {{'0', kA, {'D', 6}}, {'D', 4}},
    .right_motor = {{'0', kB, {'D', 5}}, {'D', 7}},
    .left_bump = {'D', 2},
    .right_bump = {'D', 3},
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
    .left_motor = {{'4', kA, {'H', 3}}, {'G', 5}},
    .right_motor = {{'3', kA, {'E', 3}}, {'H', 4}},
    .left_bump = {'E', 4},
    .right_bump = {'E', 5},
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
