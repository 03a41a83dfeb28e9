// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "host/live_page/ip_literal.hpp"
#include "host/live_page/web_request.hpp"

namespace echomap::live_page {

/// Who may ask: keeps out pages of other origins, names that were bound to this host, and whoever
/// lacks the token.
class RequestGuard {
 public:
  enum class Verdict : unsigned char {
    kPass,
    kForeignHost,    ///< Its Host is not ours: a name that somebody has bound to our address.
    kForeignOrigin,  ///< A page of somebody else sent it.
    kNoToken,
  };

  /// The address and port listened on; no token is demanded where it is empty.
  RequestGuard(const IpLiteral& address, std::uint16_t port, std::string token);

  Verdict judge(const WebRequest& request) const;
  /// The cookie that stands for the token from now on; empty where the request needs none.
  std::string cookie_for(const WebRequest& request) const;

 private:
  bool is_own_host(const WebRequest& request) const;
  bool is_own_origin(const WebRequest& request) const;
  bool has_token(const WebRequest& request) const;
  bool is_token(std::string_view text) const;
  std::string cookie_name() const;

  IpLiteral address_;
  std::uint16_t port_;
  std::string token_;
};

/// In a time that does not tell how much of them is the same.
bool is_same_secret(std::string_view a, std::string_view b);

}  // namespace echomap::live_page
