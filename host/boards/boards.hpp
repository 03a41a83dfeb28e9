// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "protocol/command_messages.hpp"

namespace echomap::boards {

/// How the firmware gets onto a board.
enum class FlashMethod : std::uint8_t {
  kAvrdude,  ///< By avrdude through the board's boot loader, over its serial port.
  kStm32,    ///< By st-flash through an ST-Link, or stm32flash through the boot loader in the ROM.
  kSsh,      ///< Copied by scp to a board that runs Linux, and started there.
  kUf2,      ///< Copied as a UF2 file to the drive of the boot loader in the ROM.
};

/// A board that carries the firmware: all that the host knows of it.
struct Board {
  std::string_view name;      ///< As `--board` says it; the CMake target is flash_NAME.
  std::string_view what;      ///< In words.
  std::string_view emulator;  ///< The program is echomap-EMULATOR; empty: use another board's.
  std::string_view robot;     ///< The profile that a demo drives with, where none is named.
  std::string_view image;     ///< Of the file to flash, below the build folder.
  std::string_view target;    ///< That builds the image.
  FlashMethod method = FlashMethod::kAvrdude;
  bool has_image_per_baud = true;    ///< Else one image is for every line.
  std::string_view part = {};        ///< As avrdude -p names the chip; empty without avrdude.
  std::string_view programmer = {};  ///< As avrdude -c names the boot loader; the same.
  std::vector<int> bauds = {};       ///< Of the boot loader, bits per second, tried in turn.
  std::vector<protocol::MotorBridgeKind> bridges;  ///< The kinds of motor drivers it can carry.
  bool has_own_driver = false;  ///< Motors are plugged into it; profiles name no driver.
};

/// Every board, in the order of the help.
const std::vector<Board>& all_boards();

/// The names of all boards.
std::vector<std::string> board_names();

/// The names of the boards that have an emulator.
std::vector<std::string> emulated_board_names();

/// The emulators of all boards, each once.
std::vector<std::string> emulator_names();

/// What is wrong with a name that should be one of `valid`, with the one that may be meant; empty
/// where it is one.
std::string fault_of_board(std::string_view name, const std::vector<std::string>& valid);

/// The board of this name; throws CommandError 2 where there is none.
const Board& board_named(std::string_view name);

/// The board that an emulator runs where none is named; null for what is no board's emulator.
const Board* usual_board_of(std::string_view emulator);

/// Each board's usual profile with the boards that it is of: "uno_2wd (uno, nano), ..".
std::string robots_of_boards();

/// The command that builds an emulator, and the firmware of `board` for it; where `board` is empty,
/// that of its usual board.
std::string way_to_build(std::string_view emulator, std::string_view board);

/// A kind of motor driver in words, with an example.
std::string_view words_of(protocol::MotorBridgeKind kind);

/// Whether `board` can carry motor drivers of this kind.
bool carries(const Board& board, protocol::MotorBridgeKind kind);

/// The kinds of motor drivers that `board` can carry, in words.
std::string bridges_of(const Board& board);

/// The boards that can carry motor drivers of this kind, in words: "A, B or C".
std::string boards_that_carry(protocol::MotorBridgeKind kind);

/// The names of the boards that have an emulator and can carry motor drivers of this kind.
std::vector<std::string> emulated_boards_that_carry(protocol::MotorBridgeKind kind);

}  // namespace echomap::boards
