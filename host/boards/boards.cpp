// SPDX-License-Identifier: MIT
#include "host/boards/boards.hpp"

#include <algorithm>

#include "host/console/exit_code.hpp"
#include "host/files/nearest_word.hpp"

namespace echomap::boards {
namespace {

using protocol::MotorBridgeKind;

const std::vector<MotorBridgeKind> kEveryBridge{MotorBridgeKind::kPhaseEnable,
                                                MotorBridgeKind::kIn1In2Pwm,
                                                MotorBridgeKind::kTwoPwm,
                                                MotorBridgeKind::kServo};

/// No timer is left for servos as wheels.
const std::vector<MotorBridgeKind> kEveryBridgeButServos{
    MotorBridgeKind::kPhaseEnable, MotorBridgeKind::kIn1In2Pwm, MotorBridgeKind::kTwoPwm};

/// Parts, boot loaders and rates: boards.txt of ArduinoCore-avr 1.8.7.
Board arduino_uno() {
  return {.name = "uno",
          .what = "Arduino Uno",
          .emulator = "simavr",
          .robot = "uno_2wd",
          .image = "firmware/echomap-uno.hex",
          .target = "firmware_uno",
          .part = "m328p",
          .programmer = "arduino",
          .bauds = {115200},
          .bridges = kEveryBridgeButServos};
}

/// An Uno on a smaller board.
Board arduino_nano() {
  Board board = arduino_uno();
  board.name = "nano";
  board.what = "Arduino Nano";
  board.emulator = "";
  board.bauds = {115200, 57600};  // The second is the old boot loader's.
  return board;
}

Board arduino_mega() {
  return {.name = "mega",
          .what = "Arduino Mega 2560",
          .emulator = "simavr",
          .robot = "uno_2wd",
          .image = "firmware/echomap-mega.hex",
          .target = "firmware_mega",
          .part = "m2560",
          .programmer = "wiring",
          .bauds = {115200},
          .bridges = kEveryBridge};
}

Board stm32f103() {
  return {.name = "stm32f103",
          .what = "STM32F103 board",
          .emulator = "unicorn",
          .robot = "uno_2wd",
          .image = "firmware/echomap-stm32f103.hex",
          .target = "firmware_stm32f103",
          .method = FlashMethod::kStm32,
          .bauds = {115200},
          .bridges = kEveryBridge};
}

/// Its own driver is what the firmware takes for phase/enable, the kind of profiles that name none,
/// and for the next kind, which can brake.
Board lego_ev3() {
  return {.name = "ev3",
          .what = "LEGO EV3 with ev3dev",
          .emulator = "ev3",
          .robot = "ev3",
          .image = "firmware/echomap-ev3.elf",
          .target = "firmware_ev3",
          .method = FlashMethod::kSsh,
          .has_image_per_baud = false,
          .bridges = {MotorBridgeKind::kPhaseEnable, MotorBridgeKind::kIn1In2Pwm},
          .has_own_driver = true};
}

Board raspberry_pi_pico() {
  return {.name = "pico",
          .what = "Raspberry Pi Pico",
          .emulator = "rp2040",
          .robot = "pico_2wd",
          .image = "firmware/echomap-pico.bin",
          .target = "firmware_pico",
          .method = FlashMethod::kUf2,
          .has_image_per_baud = false,
          .bridges = kEveryBridge};
}

/// "A, B or C", where `last` is " or ".
std::string in_a_row(const std::vector<std::string_view>& words, std::string_view last) {
  std::string row;
  for (std::size_t i = 0; i < words.size(); ++i) {
    row.append(i == 0 ? "" : i + 1 == words.size() ? last : ", ").append(words[i]);
  }
  return row;
}

}  // namespace

const std::vector<Board>& all_boards() {
  static const std::vector<Board> boards{
      arduino_uno(), arduino_nano(), arduino_mega(), stm32f103(), lego_ev3(), raspberry_pi_pico()};
  return boards;
}

std::vector<std::string> board_names() {
  std::vector<std::string> names;
  for (const Board& board : all_boards()) {
    names.emplace_back(board.name);
  }
  return names;
}

std::vector<std::string> emulated_board_names() {
  std::vector<std::string> names;
  for (const Board& board : all_boards()) {
    if (!board.emulator.empty()) {
      names.emplace_back(board.name);
    }
  }
  return names;
}

std::vector<std::string> emulator_names() {
  std::vector<std::string> names;
  for (const Board& board : all_boards()) {
    if (!board.emulator.empty() && std::ranges::find(names, board.emulator) == names.end()) {
      names.emplace_back(board.emulator);
    }
  }
  return names;
}

std::string fault_of_board(std::string_view name, const std::vector<std::string>& valid) {
  return std::ranges::find(valid, name) != valid.end()
             ? ""
             : "unknown board '" + std::string(name) + "'" + files::suggestion(name, valid);
}

const Board& board_named(std::string_view name) {
  const auto& boards = all_boards();
  const auto found = std::ranges::find(boards, name, &Board::name);
  if (found == boards.end()) {
    throw console::CommandError(console::ExitCode::kUsage, fault_of_board(name, board_names()));
  }
  return *found;
}

const Board* usual_board_of(std::string_view emulator) {
  const auto& boards = all_boards();
  const auto found =
      emulator.empty() ? boards.end() : std::ranges::find(boards, emulator, &Board::emulator);
  return found == boards.end() ? nullptr : &*found;
}

std::string way_to_build(std::string_view emulator, std::string_view board) {
  const Board* row = board.empty() ? usual_board_of(emulator) : &board_named(board);
  if (row == nullptr) {
    return "./run build echomap-" + std::string(emulator);
  }
  return "./run setup --all && ./run build echomap-" + std::string(emulator) + " " +
         std::string(row->target);
}

std::string_view words_of(MotorBridgeKind kind) {
  switch (kind) {
    case MotorBridgeKind::kPhaseEnable:
      return "phase/enable (DRV8835)";
    case MotorBridgeKind::kIn1In2Pwm:
      return "PWM and two direction inputs (TB6612FNG, L298N)";
    case MotorBridgeKind::kTwoPwm:
      return "two PWM inputs (DRV8833, MX1508)";
    case MotorBridgeKind::kServo:
      break;
  }
  return "servos as wheels";
}

bool carries(const Board& board, MotorBridgeKind kind) {
  return std::ranges::find(board.bridges, kind) != board.bridges.end();
}

std::string bridges_of(const Board& board) {
  if (board.has_own_driver) {
    return "no driver but its own (leave 'driver' out of the profile)";
  }
  std::vector<std::string_view> kinds;
  kinds.reserve(board.bridges.size());
  for (const MotorBridgeKind kind : board.bridges) {
    kinds.push_back(words_of(kind));
  }
  return in_a_row(kinds, " and ");
}

std::string robots_of_boards() {
  std::vector<std::pair<std::string_view, std::string>> robots;
  for (const Board& board : all_boards()) {
    const auto known = std::find_if(
        robots.begin(), robots.end(), [&](const auto& one) { return one.first == board.robot; });
    if (known == robots.end()) {
      robots.emplace_back(board.robot, board.name);
    } else {
      known->second += ", " + std::string(board.name);
    }
  }
  std::string words;
  for (const auto& [robot, names] : robots) {
    words += (words.empty() ? "" : ", ") + std::string(robot) + " (" + names + ")";
  }
  return words;
}

std::string boards_that_carry(MotorBridgeKind kind) {
  std::vector<std::string_view> found;
  for (const Board& board : all_boards()) {
    if (carries(board, kind)) {
      found.push_back(board.what);
    }
  }
  return in_a_row(found, " or ");
}

std::vector<std::string> emulated_boards_that_carry(MotorBridgeKind kind) {
  std::vector<std::string> names;
  for (const Board& board : all_boards()) {
    if (!board.emulator.empty() && carries(board, kind)) {
      names.emplace_back(board.name);
    }
  }
  return names;
}

}  // namespace echomap::boards
