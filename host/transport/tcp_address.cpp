// SPDX-License-Identifier: MIT
#include "host/transport/tcp_address.hpp"

#include <charconv>

namespace echomap::transport {
namespace {

constexpr std::string_view kTcpScheme = "tcp://";

bool is_port(std::string_view text) {
  unsigned number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size() && number > 0 && number <= 65535;
}

}  // namespace

bool is_tcp_address(std::string_view name) {
  return name.substr(0, kTcpScheme.size()) == kTcpScheme;
}

std::optional<TcpAddress> parse_tcp_address(std::string_view address) {
  if (!is_tcp_address(address)) {
    return std::nullopt;
  }
  address.remove_prefix(kTcpScheme.size());
  const std::size_t colon = address.rfind(':');
  if (colon == std::string_view::npos || !is_port(address.substr(colon + 1))) {
    return std::nullopt;
  }
  std::string_view host = address.substr(0, colon);
  if (host.size() > 2 && host.front() == '[' && host.back() == ']') {
    host = host.substr(1, host.size() - 2);
  } else if (host.find(':') != std::string_view::npos) {
    return std::nullopt;
  }
  if (host.empty() || host.find_first_of("[]") != std::string_view::npos) {
    return std::nullopt;
  }
  return TcpAddress{std::string(host), std::string(address.substr(colon + 1))};
}

}  // namespace echomap::transport
