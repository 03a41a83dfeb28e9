// SPDX-License-Identifier: MIT
#include "host/transport/bluetooth_address.hpp"

#include <charconv>
#include <system_error>

namespace echomap::transport {
namespace {

constexpr std::string_view kBluetoothScheme = "bt://";
constexpr std::size_t kAddressLength = 17;

/// All of `text` as a number; empty where it is none or above `most`.
std::optional<std::uint8_t> number(std::string_view text, int base, unsigned most) {
  unsigned value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, base);
  if (error != std::errc() || end != text.data() + text.size() || value > most) {
    return std::nullopt;
  }
  return static_cast<std::uint8_t>(value);
}

}  // namespace

bool is_bluetooth_address(std::string_view name) { return name.starts_with(kBluetoothScheme); }

std::optional<BluetoothAddress> parse_bluetooth_address(std::string_view address) {
  if (!is_bluetooth_address(address) || address.size() < kBluetoothScheme.size() + kAddressLength) {
    return std::nullopt;
  }
  address.remove_prefix(kBluetoothScheme.size());
  BluetoothAddress parsed;
  for (std::size_t i = 0; i < parsed.bytes.size(); ++i) {
    const auto byte = number(address.substr(3 * i, 2), 16, 0xFF);
    const bool separated = i == 0 || address[3 * i - 1] == ':';
    if (!byte || !separated) {
      return std::nullopt;
    }
    parsed.bytes[i] = *byte;
  }
  address.remove_prefix(kAddressLength);
  if (address.empty()) {
    return parsed;
  }
  const auto channel = address.front() == '/' ? number(address.substr(1), 10, 30) : std::nullopt;
  if (!channel || *channel == 0) {
    return std::nullopt;
  }
  parsed.channel = *channel;
  return parsed;
}

}  // namespace echomap::transport
