// SPDX-License-Identifier: MIT
#include "host/flashing/flash_plan.hpp"

#include <filesystem>
#include <optional>
#include <system_error>

#include <fmt/format.h>

#include "host/console/exit_code.hpp"
#include "host/transport/usb_table.hpp"

namespace echomap::flashing {
namespace {

using transport::KnownUsbId;
using transport::PortInfo;
using transport::UsbDevice;
using transport::UsbRole;

std::string in_words(const std::optional<transport::UsbId>& id, const std::string& description) {
  if (!id) {
    return "no USB id";
  }
  const KnownUsbId* known = known_usb_id(*id);
  const std::string what = known != nullptr ? std::string(known->what) : description;
  return to_string(*id) + (what.empty() ? "" : ", " + what);
}

std::string in_words(const PortInfo& port) {
  return port.name + " (" + in_words(port.usb_id, port.description) + ")";
}

UsbRole role_of(const UsbDevice& device) {
  const KnownUsbId* known = known_usb_id(device.id);
  return known != nullptr ? known->role : UsbRole::kSerialChip;
}

std::vector<UsbDevice> programmers(const AttachedDevices& attached) {
  std::vector<UsbDevice> found;
  for (const UsbDevice& device : attached.usb) {
    if (role_of(device) == UsbRole::kProgrammer) {
      found.push_back(device);
    }
  }
  return found;
}

/// Ends the command: `what`, the ports and programmers that are here, what to do.
[[noreturn]] void refuse(const std::string& what,
                         const std::string& next,
                         const AttachedDevices& attached) {
  std::string text = what + "\n";
  for (const PortInfo& port : attached.ports) {
    text += "  here: " + in_words(port) + "\n";
  }
  for (const UsbDevice& device : programmers(attached)) {
    text += "  here: " + in_words(device.id, device.description) + ", serial number " +
            device.serial_number + "\n";
  }
  throw console::CommandError(console::ExitCode::kNoRobot, text + "  next: " + next);
}

PortInfo named_port(const std::string& name, const AttachedDevices& attached) {
  if (const auto text = transport::port_id_text(name)) {
    const auto fitting = transport::ports_with_id(attached.ports, *text);
    if (fitting.size() == 1) {
      return fitting.front();
    }
    refuse(fmt::format("{} ports fit '{}'", fitting.empty() ? "no" : "several", name),
           "name the port with --port",
           attached);
  }
  std::error_code ignored;
  const std::string device = std::filesystem::weakly_canonical(name, ignored).string();
  for (const PortInfo& port : attached.ports) {
    if (port.name == device) {
      return port;
    }
  }
  return {name, "", ""};
}

/// A chip with a USB of its own has no boot loader at its serial port.
bool is_flashed_by_port(const KnownUsbId& known) {
  return known.role == UsbRole::kBoard || known.role == UsbRole::kSerialChip;
}

/// The board at `port`, from what was said and from the port's id.
const boards::Board& board_at(const PortInfo& port,
                              const boards::Board* said,
                              const AttachedDevices& attached) {
  const std::string will_not = "will not flash " + in_words(port) + ": ";
  const KnownUsbId* known = port.usb_id ? known_usb_id(*port.usb_id) : nullptr;
  if (known == nullptr || !is_flashed_by_port(*known)) {
    refuse(will_not + "no board that echomap knows has that",
           "name the port of a board with --port; docs/guides/flashing.md lists their ids",
           attached);
  }
  if (known->role == UsbRole::kBoard) {
    if (said != nullptr && said->name != known->board) {
      refuse(fmt::format("{}it is no {}", will_not, said->what),
             fmt::format("--board {}, or the port of another board", known->board),
             attached);
    }
    return boards::board_named(known->board);
  }
  if (said == nullptr) {
    refuse(will_not + "many things have this serial chip, and boards of every kind",
           fmt::format("say which board it is: --port {} --board NAME", port.name),
           attached);
  }
  return *said;
}

FlashTarget target_at(const PortInfo& port, const boards::Board& board) {
  return {&board, port.name, "", in_words(port)};
}

/// The one board here that its USB id gives away.
FlashTarget only_board(const boards::Board* said, const AttachedDevices& attached) {
  std::vector<FlashTarget> found;
  for (const PortInfo& port : attached.ports) {
    const KnownUsbId* known = port.usb_id ? known_usb_id(*port.usb_id) : nullptr;
    if (known != nullptr && known->role == UsbRole::kBoard &&
        (said == nullptr || said->name == known->board)) {
      found.push_back(target_at(port, boards::board_named(known->board)));
    }
  }
  if (found.size() == 1) {
    return found.front();
  }
  if (!found.empty()) {
    refuse("several boards are here", "name one with --port", attached);
  }
  refuse(fmt::format("no {} is here that its USB id gives away",
                     said != nullptr ? said->what : "board"),
         "plug it in; a board with a serial chip of its own needs both said: --port and --board",
         attached);
}

/// The ST-Link; `id` is a part of its serial number, or empty.
FlashTarget programmer_target(const boards::Board& board,
                              const std::string& id,
                              const AttachedDevices& attached) {
  const auto here = programmers(attached);
  std::vector<UsbDevice> fitting;
  for (const UsbDevice& device : here) {
    if (device.serial_number.find(id) != std::string::npos) {
      fitting.push_back(device);
    }
  }
  if (fitting.size() != 1) {
    refuse(fitting.empty() ? "no ST-Link is here that fits" : "several ST-Links are here",
           "plug one in, name one with --port id:SERIAL_NUMBER, or name a serial port",
           attached);
  }
  const std::string serial = here.size() > 1 ? fitting.front().serial_number : "";
  return {&board, "", serial, "the ST-Link (" + to_string(fitting.front().id) + ")"};
}

FlashPlan avrdude_plan(const FlashTarget& target, const std::string& image) {
  FlashPlan plan{target.what,
                 {},
                 "avrdude",
                 "is it the board that --board says? does another program use the port? press the "
                 "board's reset button and try again"};
  for (const int baud : target.board->bauds) {
    plan.tries.push_back({"avrdude",
                          "-p",
                          std::string(target.board->part),
                          "-c",
                          std::string(target.board->programmer),
                          "-P",
                          target.port,
                          "-b",
                          std::to_string(baud),
                          "-D",
                          "-U",
                          "flash:w:" + image + ":i"});
  }
  return plan;
}

FlashPlan st_flash_plan(const FlashTarget& target, const std::string& image) {
  console::CommandWords command{"st-flash", "--reset", "--format", "ihex"};
  if (!target.serial.empty()) {
    command.insert(command.end(), {"--serial", target.serial});
  }
  command.insert(command.end(), {"write", image});
  return {target.what,
          {command},
          "stlink-tools",
          "look at the wires SWDIO, SWCLK, GND and 3V3 between ST-Link and board"};
}

FlashPlan stm32flash_plan(const FlashTarget& target, const std::string& image) {
  const std::string baud = std::to_string(target.board->bauds.front());
  return {target.what,
          {{"stm32flash", "-b", baud, "-w", image, "-v", "-g", "0x0", target.port}},
          "stm32flash",
          "set the jumper BOOT0 to 1 and press reset; set it back afterwards"};
}

}  // namespace

FlashTarget choose_flash_target(const FlashRequest& request, const AttachedDevices& attached) {
  const boards::Board* said = request.board.empty() ? nullptr : &boards::board_named(request.board);
  const auto id = transport::port_id_text(request.port);
  if (said != nullptr && said->method == boards::FlashMethod::kStm32 &&
      (request.port.empty() || id)) {
    return programmer_target(*said, std::string(id.value_or("")), attached);
  }
  if (request.port.empty()) {
    return only_board(said, attached);
  }
  const PortInfo port = named_port(request.port, attached);
  return target_at(port, board_at(port, said, attached));
}

FlashPlan flash_plan(const FlashTarget& target, const std::string& image) {
  if (target.board->method == boards::FlashMethod::kAvrdude) {
    return avrdude_plan(target, image);
  }
  return target.port.empty() ? st_flash_plan(target, image) : stm32flash_plan(target, image);
}

}  // namespace echomap::flashing
