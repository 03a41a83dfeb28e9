// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "host/transport/usb_id.hpp"

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

/// What hangs on the USB, by its id.
enum class UsbRole : std::uint8_t {
  kBoard,       ///< One kind of board and nothing else.
  kSerialChip,  ///< A serial chip of boards, and of printers, modems and meters too.
  kProgrammer,  ///< An ST-Link.
};

/// A USB id that may be flashed at all.
struct KnownUsbId {
  transport::UsbId id;
  UsbRole role = UsbRole::kSerialChip;
  std::string_view what;
  std::string_view board;  ///< Name of the only board with this id; empty for the other roles.
};

/// Every id that may be flashed.
std::span<const KnownUsbId> known_usb_ids();

/// What is known of an id; null for what is no board's.
const KnownUsbId* known_usb_id(transport::UsbId id);

}  // namespace echomap::flashing
