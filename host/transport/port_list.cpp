// SPDX-License-Identifier: MIT
#include "host/transport/port_list.hpp"

#include <algorithm>
#include <iterator>
#include <libserialport.h>
#include <memory>

namespace echomap::transport {
namespace {

std::optional<UsbId> usb_id_of(const sp_port* port) {
  int vendor = 0;
  int product = 0;
  if (sp_get_port_usb_vid_pid(port, &vendor, &product) != SP_OK) {
    return std::nullopt;
  }
  return UsbId{static_cast<std::uint16_t>(vendor), static_cast<std::uint16_t>(product)};
}

PortInfo info_of(const sp_port* port) {
  const auto text = [](const char* words) { return std::string(words == nullptr ? "" : words); };
  return {sp_get_port_name(port),
          text(sp_get_port_description(port)),
          text(sp_get_port_usb_serial(port)),
          usb_id_of(port)};
}

}  // namespace

std::vector<PortInfo> list_ports() {
  sp_port** found = nullptr;
  if (sp_list_ports(&found) != SP_OK) {
    return {};
  }
  const std::unique_ptr<sp_port*, decltype(&sp_free_port_list)> owner(found, sp_free_port_list);
  std::vector<PortInfo> ports;
  for (sp_port** port = found; *port != nullptr; ++port) {
    if (sp_get_port_transport(*port) != SP_TRANSPORT_NATIVE) {
      ports.push_back(info_of(*port));
    }
  }
  return ports;
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
