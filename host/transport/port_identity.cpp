// SPDX-License-Identifier: MIT
#include "host/transport/port_identity.hpp"

#include <algorithm>
#include <filesystem>

#include <sys/stat.h>

#include "host/transport/open_stream.hpp"
#include "host/transport/port_list.hpp"

namespace echomap::transport {
namespace {

/// A link tells one publishing from the next by its time; a bare pty has nothing of the kind.
std::string stamp_of_link(const std::string& port) {
  struct stat status {};
  if (::lstat(port.c_str(), &status) != 0 || !S_ISLNK(status.st_mode)) {
    return "";
  }
  return std::to_string(status.st_ino) + '.' + std::to_string(status.st_mtim.tv_sec) + '.' +
         std::to_string(status.st_mtim.tv_nsec);
}

/// Serial number and description of the USB device; empty where it is none.
std::string stamp_of_device(const std::string& port) {
  std::error_code ignored;
  const std::string device = std::filesystem::weakly_canonical(port, ignored).string();
  const auto ports = list_ports();
  const auto found = std::find_if(
      ports.begin(), ports.end(), [&](const PortInfo& info) { return info.name == device; });
  return found == ports.end() ? "" : found->serial_number + ' ' + found->description;
}

std::string stamp_of(const std::string& port) {
  switch (port_kind(port)) {
    case PortKind::kPty:
      return stamp_of_link(port);
    case PortKind::kSerial:
      return stamp_of_device(port);
    default:
      return "";
  }
}

}  // namespace

PortIdentity::PortIdentity(const std::string& port) : port_(port), stamp_(stamp_of(port)) {}

std::string PortIdentity::objection() const {
  const std::string now = stamp_of(port_);
  if (port_kind(port_) == PortKind::kPty && (now.empty() || now == stamp_)) {
    return "the program at its other end is gone";
  }
  if (port_kind(port_) == PortKind::kSerial && now != stamp_) {
    return "another device has its name now";
  }
  return "";
}

}  // namespace echomap::transport
