// SPDX-License-Identifier: MIT
#include "tests/ports/staged_desk.hpp"

#include <algorithm>
#include <stdexcept>
#include <termios.h>

#include "host/console/exit_code.hpp"
#include "host/robot_link/robot_probe.hpp"
#include "host/transport/port_holder.hpp"
#include "host/transport/pty_port.hpp"
#include "host/transport/transport_error.hpp"

namespace echomap::tests {
namespace {

using transport::PortInfo;
using transport::UsbId;

constexpr UsbId kCh340{0x1a86, 0x7523};

std::string settings_of(int fd) {
  termios settings{};
  ::tcgetattr(fd, &settings);
  return {reinterpret_cast<const char*>(&settings), sizeof settings};
}

}  // namespace

StagedDesk::StagedDesk() {
  add("ttyUSB0", {"1-1.1", kCh340, "USB Serial"}, "");
  add("ttyUSB1", {"1-1.2", kCh340, "USB Serial"}, "start\necho:Marlin 2.1.2\n");
  add("ttyACM0", {"1-1.3", {0x1d50, 0x614e}, "stm32f103xe", "3B00"}, "~");
  add("ttyUSB2", {"1-1.4", {0x12d1, 0x1506}, "HUAWEI Mobile"}, "^BOOT:1,0\r\nERROR\r\n");
  add("ttyUSB3", {"1-2", {0x0403, 0x6001}, "FT232R USB UART", "LP17"}, "PAPER OUT\r\n");
  add("ttyACM1", {"1-3", {0x2341, 0x0043}, "Arduino Uno", "7583"}, "");
  for (const auto& [port, device] : devices_) {
    settings_[port] = settings_of(device.fd());
  }
  driver_.emplace(devices_.at(kRunningRobot).name(), PortKeeping::kFlock);
}

void StagedDesk::add(const std::string& tty,
                     const SysfsTree::Device& device,
                     const std::string& greeting) {
  sysfs_.plug(tty, device);
  devices_["/dev/" + tty].write(
      {reinterpret_cast<const std::uint8_t*>(greeting.data()), greeting.size()});
}

session::PortSurroundings StagedDesk::surroundings() {
  const auto ask = [this](const std::string&) {
    return answered_ < answers_.size() ? std::optional(answers_[answered_++]) : std::nullopt;
  };
  return {
      transport::list_ports(sysfs_.root()),
      [this](const PortInfo& port) { return std::ranges::find(known_, port.name) != known_.end(); },
      [this](const PortInfo& port) {
        return !transport::port_holders(devices_.at(port.name).name()).empty();
      },
      ask};
}

std::unique_ptr<transport::ByteStream> StagedDesk::open(const std::string& port) {
  strangers_openings_ += port == kRobot ? 0 : 1;
  return transport::open_pty_port(devices_.at(port).name());
}

std::string StagedDesk::connect(const std::vector<std::string>& named) {
  constexpr std::uint16_t kSession = 7;
  try {
    std::string chosen;
    const auto stream = session::choose_port(
        session::candidate_ports(named, surroundings()),
        [&](const std::string& port) {
          chosen = port;
          return open(port);
        },
        kSession);
    stream->write(robot_link::RobotProbe(kSession).hello());
    return chosen;
  } catch (const console::CommandError& error) {
    return error.what();
  } catch (const transport::TransportError& error) {
    return error.what();
  }
}

std::size_t StagedDesk::strangers_bytes() const {
  std::size_t bytes = 0;
  for (const auto& [port, device] : devices_) {
    bytes += port == kRobot ? 0 : device.unread_bytes();
  }
  return bytes;
}

bool StagedDesk::are_lines_as_before() const {
  return std::ranges::all_of(devices_, [&](const auto& entry) {
    return entry.first == kRobot || settings_of(entry.second.fd()) == settings_.at(entry.first);
  });
}

std::size_t measure_strangers_bytes() {
  StagedDesk desk;
  std::size_t wrong = 0;
  const auto expect = [&](bool finds_robot, const std::vector<std::string>& named = {}) {
    const bool found = desk.connect(named) == StagedDesk::kRobot;
    wrong += found == finds_robot ? 0 : 1;
  };
  expect(false);  // Nobody can be asked.
  desk.set_answers({"2", ""});
  expect(true);   // The second of the list.
  expect(false);  // None of it.
  desk.set_known({StagedDesk::kRobot, StagedDesk::kRunningRobot});
  expect(true);  // The one that does not run.
  expect(true, {StagedDesk::kRobot});
  const int openings = desk.strangers_openings();
  expect(false, {StagedDesk::kRunningRobot});  // Refused, though it is named.
  desk.unplug_robot();
  expect(false);
  return wrong + static_cast<std::size_t>(openings) + desk.strangers_bytes() +
         (desk.are_lines_as_before() ? 0 : 1);
}

}  // namespace echomap::tests
