// SPDX-License-Identifier: MIT
#include "host/transport/port_list.hpp"

#include <algorithm>
#include <iterator>
#include <system_error>
#include <utility>

#include "host/transport/usb_devices.hpp"

namespace echomap::transport {
namespace {

namespace fs = std::filesystem;

/// The factory's serial number of every CP2102: none of its own.
constexpr std::string_view kNumberOfAll = "0001";

/// A Pico that runs the firmware of echomap, and the serial number that it has for every one.
constexpr UsbId kPico{0x2e8a, 0x000a};
constexpr std::string_view kNumberOfPicos = "1";

bool has_own_number(const PortInfo& port) {
  const bool is_that_of_picos = port.usb_id == kPico && port.serial_number == kNumberOfPicos;
  return !port.serial_number.empty() && port.serial_number != kNumberOfAll && !is_that_of_picos;
}

std::string interface_of(const PortInfo& port) {
  const std::size_t colon = port.usb_path.find(':');
  return colon == std::string::npos ? "" : port.usb_path.substr(colon);
}

/// The port of the tty in this folder of /sys/class/tty; empty where it is neither on the USB nor
/// on Bluetooth.
std::optional<PortInfo> port_of_tty(const fs::path& tty) {
  const std::string name = "/dev/" + tty.filename().string();
  if (tty.filename().string().starts_with("rfcomm")) {
    return PortInfo{name, "Bluetooth", ""};
  }
  std::error_code none;
  for (fs::path place = fs::canonical(tty / "device", none); place.has_relative_path();
       place = place.parent_path()) {
    const std::string interface = place.filename().string();
    if (interface.find(':') == std::string::npos) {
      continue;
    }
    if (const auto device = usb_device_at(place.parent_path())) {
      return PortInfo{name, device->description, device->serial_number, device->id, interface};
    }
  }
  return std::nullopt;
}

}  // namespace

std::vector<PortInfo> list_ports(const fs::path& sysfs) {
  std::vector<PortInfo> ports;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(sysfs / "class" / "tty", none)) {
    if (auto port = port_of_tty(entry.path())) {
      ports.push_back(std::move(*port));
    }
  }
  std::ranges::sort(ports, {}, &PortInfo::name);
  return ports;
}

bool is_same_device(const PortInfo& one, const PortInfo& other) {
  if (one.usb_id != other.usb_id || one.description != other.description ||
      one.serial_number != other.serial_number) {
    return false;
  }
  if (has_own_number(one)) {
    return interface_of(one) == interface_of(other);
  }
  return one.usb_path.empty() ? one.name == other.name : one.usb_path == other.usb_path;
}

std::optional<std::string_view> port_id_text(std::string_view name) {
  constexpr std::string_view kScheme = "id:";
  return name.starts_with(kScheme) ? std::optional(name.substr(kScheme.size())) : std::nullopt;
}

std::vector<PortInfo> ports_with_id(const std::vector<PortInfo>& ports, std::string_view text) {
  std::vector<PortInfo> fitting;
  std::copy_if(ports.begin(), ports.end(), std::back_inserter(fitting), [&](const PortInfo& port) {
    return port.serial_number.find(text) != std::string::npos ||
           port.description.find(text) != std::string::npos;
  });
  return fitting;
}

std::string describe_ports(const std::vector<PortInfo>& ports) {
  if (ports.empty()) {
    return "no USB or Bluetooth serial port is here";
  }
  std::string text = "ports here:";
  for (const PortInfo& port : ports) {
    text += ' ' + port.name;
    if (!port.description.empty()) {
      text += " (" + port.description + ')';
    }
  }
  return text;
}

}  // namespace echomap::transport
