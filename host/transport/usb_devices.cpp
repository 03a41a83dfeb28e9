// SPDX-License-Identifier: MIT
#include "host/transport/usb_devices.hpp"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <fstream>
#include <system_error>
#include <utility>

namespace echomap::transport {
namespace {

namespace fs = std::filesystem;

/// The one line of an attribute's file; empty where there is none.
std::string attribute(const fs::path& device, const char* name) {
  std::ifstream file(device / name);
  std::string line;
  std::getline(file, line);
  return line;
}

std::optional<std::uint16_t> hexadecimal(const std::string& text) {
  std::uint16_t number = 0;
  const char* const end = text.data() + text.size();
  const auto parsed = std::from_chars(text.data(), end, number, 16);
  return parsed.ec == std::errc() && parsed.ptr == end ? std::optional(number) : std::nullopt;
}

}  // namespace

std::optional<UsbDevice> usb_device_at(const fs::path& folder) {
  const auto vendor = hexadecimal(attribute(folder, "idVendor"));
  const auto product = hexadecimal(attribute(folder, "idProduct"));
  if (!vendor || !product) {
    return std::nullopt;
  }
  return UsbDevice{{*vendor, *product}, attribute(folder, "product"), attribute(folder, "serial")};
}

std::vector<UsbDevice> list_usb_devices(const fs::path& folder) {
  std::vector<fs::path> entries;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(folder, none)) {
    entries.push_back(entry.path());
  }
  std::sort(entries.begin(), entries.end());
  std::vector<UsbDevice> devices;
  for (const fs::path& entry : entries) {
    if (auto device = usb_device_at(entry)) {
      devices.push_back(std::move(*device));
    }
  }
  return devices;
}

}  // namespace echomap::transport
