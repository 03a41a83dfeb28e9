// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace echomap::transport {

/// The two parts of "tcp://host:port".
struct TcpAddress {
  std::string host;  ///< Name or number; an IPv6 number without its brackets.
  std::string port;  ///< 1 .. 65535, in digits.
};

/// True for names that mean a TCP address, right or wrong.
bool is_tcp_address(std::string_view name);

/// Takes an address apart; empty where host or port is missing or the port is not one.
std::optional<TcpAddress> parse_tcp_address(std::string_view address);

}  // namespace echomap::transport
