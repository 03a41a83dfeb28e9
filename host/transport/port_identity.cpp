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

}  // namespace

PortIdentity::PortIdentity(const std::string& port, ListPorts list)
    : port_(port), list_(std::move(list)) {
  if (port_kind(port) == PortKind::kPty) {
    link_ = stamp_of_link(port);
  } else if (port_kind(port) == PortKind::kSerial) {
    device_ = device_here();
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
  std::vector<PortInfo> same = list_();
  const bool name_is_given = std::ranges::find(same, device_name(), &PortInfo::name) != same.end();
  // NOLINTNEXTLINE(bugprone-unchecked-optional-access): name_now() has checked it
  std::erase_if(same, [&](const PortInfo& port) { return !is_same_device(port, *device_); });
  if (same.size() == 1) {
    // What the user called it, a link perhaps, as long as it leads there.
    return same.front().name == device_name() ? port_ : same.front().name;
  }
  if (same.size() > 1) {
    refuse("several devices have its serial number now");
  }
  refuse(name_is_given ? "another device has its name now" : "it is not plugged in");
}

std::string PortIdentity::device_name() const {
  std::error_code ignored;
  return std::filesystem::weakly_canonical(port_, ignored).string();
}

std::optional<PortInfo> PortIdentity::device_here() const {
  const auto ports = list_();
  const auto found = std::ranges::find(ports, device_name(), &PortInfo::name);
  return found == ports.end() ? std::nullopt : std::optional(*found);
}

void PortIdentity::refuse(const std::string& why) const {
  throw TransportError("cannot reopen " + port_, why, "plug it in, or start again");
}

}  // namespace echomap::transport
