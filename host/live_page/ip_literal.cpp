// SPDX-License-Identifier: MIT
#include "host/live_page/ip_literal.hpp"

#include <algorithm>
#include <charconv>

#include <arpa/inet.h>

#include "host/live_page/web_request.hpp"

namespace echomap::live_page {

std::optional<IpLiteral> IpLiteral::parse(std::string_view text) {
  const std::string number(text);
  if (number.find('\0') != std::string::npos) {
    return std::nullopt;
  }
  IpLiteral literal;
  if (::inet_pton(AF_INET, number.c_str(), literal.bytes_.data()) == 1) {
    return literal;
  }
  literal.is_v6_ = true;
  if (::inet_pton(AF_INET6, number.c_str(), literal.bytes_.data()) == 1) {
    return literal;
  }
  return std::nullopt;
}

bool IpLiteral::is_loopback() const {
  constexpr std::array<unsigned char, 16> kV6{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1};
  return is_v6_ ? bytes_ == kV6 : bytes_[0] == 127;
}

bool IpLiteral::is_any() const {
  return std::all_of(bytes_.begin(), bytes_.end(), [](unsigned char byte) { return byte == 0; });
}

std::optional<HostAndPort> HostAndPort::parse(std::string_view text, unsigned default_port) {
  HostAndPort result{{}, default_port};
  std::string_view rest;
  if (text.starts_with('[')) {
    const std::size_t end = text.find(']');
    if (end == std::string_view::npos) {
      return std::nullopt;
    }
    result.host = lower_case(text.substr(1, end - 1));
    rest = text.substr(end + 1);
  } else {
    const std::size_t end = std::min(text.find(':'), text.size());
    result.host = lower_case(text.substr(0, end));
    rest = text.substr(end);
  }
  if (result.host.empty()) {
    return std::nullopt;
  }
  if (rest.empty()) {
    return result;
  }
  const char* end = rest.data() + rest.size();
  const auto [stop, error] = std::from_chars(rest.data() + 1, end, result.port);
  if (rest.front() != ':' || error != std::errc() || stop != end || result.port > 65535) {
    return std::nullopt;
  }
  return result;
}

}  // namespace echomap::live_page
