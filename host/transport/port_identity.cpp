// SPDX-License-Identifier: MIT
#include "host/transport/port_identity.hpp"

#include <algorithm>
#include <filesystem>
#include <utility>

#include <sys/stat.h>

#include "host/transport/open_stream.hpp"
#include "host/transport/transport_error.hpp"

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

bool is_same_device(const PortInfo& one, const PortInfo& other) {
  return one.serial_number == other.serial_number && one.description == other.description;
}

}  // namespace

PortIdentity::PortIdentity(const std::string& port, ListPorts list)
    : port_(port), list_(std::move(list)) {
  if (port_kind(port) == PortKind::kPty) {
    link_ = stamp_of_link(port);
  } else if (port_kind(port) == PortKind::kSerial) {
    device_ = device_at(port);
  }
}

std::string PortIdentity::name_now() const {
  if (device_) {
    return device_name_now();
  }
  if (port_kind(port_) == PortKind::kPty) {
    const std::string link = stamp_of_link(port_);
    if (link.empty() || link == link_) {
      refuse("the program at its other end is gone");
    }
  }
  return port_;
}

std::string PortIdentity::device_name_now() const {
  const auto at_its_name = device_at(port_);
  // NOLINTNEXTLINE(bugprone-unchecked-optional-access): name_now() has checked it
  if (at_its_name && is_same_device(*at_its_name, *device_)) {
    return port_;
  }
  std::vector<PortInfo> same = list_();
  // NOLINTNEXTLINE(bugprone-unchecked-optional-access): name_now() has checked it
  std::erase_if(same, [&](const PortInfo& port) { return !is_same_device(port, *device_); });
  // NOLINTNEXTLINE(bugprone-unchecked-optional-access): name_now() has checked it
  if (!device_->serial_number.empty() && same.size() == 1) {
    return same.front().name;
  }
  refuse(at_its_name ? "another device has its name now" : "it is not plugged in");
}

std::optional<PortInfo> PortIdentity::device_at(const std::string& port) const {
  std::error_code ignored;
  const std::string device = std::filesystem::weakly_canonical(port, ignored).string();
  const auto ports = list_();
  const auto found = std::ranges::find(ports, device, &PortInfo::name);
  return found == ports.end() ? std::nullopt : std::optional(*found);
}

void PortIdentity::refuse(const std::string& why) const {
  throw TransportError("cannot reopen " + port_, why, "plug it in, or start again");
}

}  // namespace echomap::transport
