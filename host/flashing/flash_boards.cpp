// SPDX-License-Identifier: MIT
#include "host/flashing/flash_boards.hpp"

#include <algorithm>

#include "host/console/exit_code.hpp"
#include "host/files/nearest_word.hpp"

namespace echomap::flashing {
const std::vector<FlashBoard>& flash_boards() {
  // Parts, boot loaders and rates: boards.txt of ArduinoCore-avr 1.8.7.
  static const std::vector<FlashBoard> boards{
      {.name = "uno",
       .what = "Arduino Uno",
       .image = "firmware/echomap-uno.hex",
       .target = "firmware_uno",
       .part = "m328p",
       .programmer = "arduino",
       .bauds = {115200}},
      {.name = "nano",
       .what = "Arduino Nano",
       .image = "firmware/echomap-uno.hex",
       .target = "firmware_uno",
       .part = "m328p",
       .programmer = "arduino",
       .bauds = {115200, 57600}},  // The second is the old boot loader's.
      {.name = "mega",
       .what = "Arduino Mega 2560",
       .image = "firmware/echomap-mega.hex",
       .target = "firmware_mega",
       .part = "m2560",
       .programmer = "wiring",
       .bauds = {115200}},
      {.name = "stm32f103",
       .what = "STM32F103 board",
       .image = "firmware/echomap-stm32f103.hex",
       .target = "firmware_stm32f103",
       .tool = FlashTool::kStm32,
       .bauds = {115200}},
  };
  return boards;
}

std::vector<std::string> flash_board_names() {
  std::vector<std::string> names;
  for (const FlashBoard& board : flash_boards()) {
    names.emplace_back(board.name);
  }
  return names;
}

const FlashBoard& flash_board(std::string_view name) {
  const auto& boards = flash_boards();
  const auto found = std::find_if(
      boards.begin(), boards.end(), [&](const FlashBoard& board) { return board.name == name; });
  if (found == boards.end()) {
    throw console::CommandError(
        console::ExitCode::kUsage,
        "unknown board '" + std::string(name) + "'" + files::suggestion(name, flash_board_names()));
  }
  return *found;
}

}  // namespace echomap::flashing
