// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace echomap::transport {

/// The parts of "bt://00:14:03:05:59:02" or "bt://00:14:03:05:59:02/3".
struct BluetoothAddress {
  std::array<std::uint8_t, 6> bytes{};  ///< As written, the first byte first.
  std::uint8_t channel = 1;             ///< RFCOMM channel, 1 .. 30; serial modules listen on 1.
};

/// True for names that mean a Bluetooth address, right or wrong.
bool is_bluetooth_address(std::string_view name);

/// Takes an address apart; empty where it is none.
std::optional<BluetoothAddress> parse_bluetooth_address(std::string_view address);

}  // namespace echomap::transport
