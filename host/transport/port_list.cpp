// SPDX-License-Identifier: MIT
#include "host/transport/port_list.hpp"

#include <libserialport.h>
#include <memory>

namespace echomap::transport {
namespace {

PortInfo info_of(const sp_port* port) {
  const auto text = [](const char* words) { return std::string(words == nullptr ? "" : words); };
  return {sp_get_port_name(port),
          text(sp_get_port_description(port)),
          text(sp_get_port_usb_serial(port))};
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
