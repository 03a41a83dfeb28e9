// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace echomap::flashing {

/// What writes the flash of a board.
enum class FlashTool : std::uint8_t {
  kAvrdude,  ///< Through the board's boot loader, over its serial port.
  kStm32,    ///< st-flash through an ST-Link, or stm32flash through the boot loader in the ROM.
};

/// A board that `echomap flash` knows.
struct FlashBoard {
  std::string_view name;    ///< As `--board` says it; the CMake target is flash_NAME.
  std::string_view what;    ///< In words.
  std::string_view image;   ///< Of the Intel hex file, below the build folder.
  std::string_view target;  ///< That builds the image.
  FlashTool tool = FlashTool::kAvrdude;
  std::string_view part = {};        ///< As avrdude -p names the chip; empty without avrdude.
  std::string_view programmer = {};  ///< As avrdude -c names the boot loader; the same.
  std::vector<int> bauds;            ///< Of the boot loader, bits per second, tried in turn.
};

/// Every board, in the order of the help.
const std::vector<FlashBoard>& flash_boards();

/// The names of all boards.
std::vector<std::string> flash_board_names();

/// The board of this name; throws CommandError 2 where there is none.
const FlashBoard& flash_board(std::string_view name);

}  // namespace echomap::flashing
