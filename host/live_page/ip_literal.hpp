// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace echomap::live_page {

/// An IP address by its number.
class IpLiteral {
 public:
  /// As in "127.0.0.1" or "::1"; nothing for anything else.
  static std::optional<IpLiteral> parse(std::string_view text);

  bool is_v6() const { return is_v6_; }
  bool is_loopback() const;
  /// 0.0.0.0 or ::, which stand for every address of the host.
  bool is_any() const;
  bool operator==(const IpLiteral&) const = default;

 private:
  std::array<unsigned char, 16> bytes_{};
  bool is_v6_ = false;
};

/// Host and port as in a Host header; the port is 80 where none is written, the number of an IPv6
/// address without its brackets. Nothing where the text is neither.
struct HostAndPort {
  std::string host;  ///< In lower case.
  unsigned port = 80;

  static std::optional<HostAndPort> parse(std::string_view text, unsigned default_port = 80);
  bool operator==(const HostAndPort&) const = default;
};

}  // namespace echomap::live_page
