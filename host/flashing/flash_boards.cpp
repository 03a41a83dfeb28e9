// SPDX-License-Identifier: MIT
#include "host/flashing/flash_boards.hpp"

#include <algorithm>
#include <array>

#include "host/console/exit_code.hpp"
#include "host/files/nearest_word.hpp"

namespace echomap::flashing {
namespace {

/// Arduino and its sister firm arduino.org: boards.txt of ArduinoCore-avr 1.8.7. Serial chips: the
/// drivers ch341, ftdi_sio and cp210x of Linux. ST-Links that stand alone: the udev rules of
/// stlink-tools; those soldered to a Nucleo or Discovery board are left out, for that is another
/// board.
constexpr std::array kKnownUsbIds{
    KnownUsbId{{0x2341, 0x0043}, UsbRole::kBoard, "Arduino Uno R3", "uno"},
    KnownUsbId{{0x2341, 0x0001}, UsbRole::kBoard, "Arduino Uno", "uno"},
    KnownUsbId{{0x2341, 0x0243}, UsbRole::kBoard, "Arduino Uno R3", "uno"},
    KnownUsbId{{0x2341, 0x006a}, UsbRole::kBoard, "Arduino Uno", "uno"},
    KnownUsbId{{0x2a03, 0x0043}, UsbRole::kBoard, "Arduino Uno R3", "uno"},
    KnownUsbId{{0x2341, 0x0010}, UsbRole::kBoard, "Arduino Mega 2560", "mega"},
    KnownUsbId{{0x2341, 0x0042}, UsbRole::kBoard, "Arduino Mega 2560 R3", "mega"},
    KnownUsbId{{0x2341, 0x0210}, UsbRole::kBoard, "Arduino Mega 2560", "mega"},
    KnownUsbId{{0x2341, 0x0242}, UsbRole::kBoard, "Arduino Mega 2560 R3", "mega"},
    KnownUsbId{{0x2a03, 0x0010}, UsbRole::kBoard, "Arduino Mega 2560", "mega"},
    KnownUsbId{{0x2a03, 0x0042}, UsbRole::kBoard, "Arduino Mega 2560 R3", "mega"},
    KnownUsbId{{0x1a86, 0x7523}, UsbRole::kSerialChip, "CH340", ""},
    KnownUsbId{{0x1a86, 0x5523}, UsbRole::kSerialChip, "CH341", ""},
    KnownUsbId{{0x0403, 0x6001}, UsbRole::kSerialChip, "FTDI FT232R", ""},
    KnownUsbId{{0x0403, 0x6015}, UsbRole::kSerialChip, "FTDI FT231X", ""},
    KnownUsbId{{0x10c4, 0xea60}, UsbRole::kSerialChip, "CP2102", ""},
    KnownUsbId{{0x0483, 0x3748}, UsbRole::kProgrammer, "ST-Link V2", ""},
    KnownUsbId{{0x0483, 0x374d}, UsbRole::kProgrammer, "ST-Link V3", ""},
    KnownUsbId{{0x0483, 0x374e}, UsbRole::kProgrammer, "ST-Link V3", ""},
    KnownUsbId{{0x0483, 0x374f}, UsbRole::kProgrammer, "ST-Link V3", ""},
    KnownUsbId{{0x0483, 0x3753}, UsbRole::kProgrammer, "ST-Link V3", ""},
};

}  // namespace

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

std::span<const KnownUsbId> known_usb_ids() { return kKnownUsbIds; }

const KnownUsbId* known_usb_id(transport::UsbId id) {
  const auto found = std::find_if(kKnownUsbIds.begin(),
                                  kKnownUsbIds.end(),
                                  [&](const KnownUsbId& known) { return known.id == id; });
  return found == kKnownUsbIds.end() ? nullptr : &*found;
}

}  // namespace echomap::flashing
