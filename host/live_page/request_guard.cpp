// SPDX-License-Identifier: MIT
#include "host/live_page/request_guard.hpp"

#include <algorithm>
#include <utility>

namespace echomap::live_page {

RequestGuard::RequestGuard(const IpLiteral& address, std::uint16_t port, std::string token)
    : address_(address), port_(port), token_(std::move(token)) {}

RequestGuard::Verdict RequestGuard::judge(const WebRequest& request) const {
  if (!is_own_host(request)) {
    return Verdict::kForeignHost;
  }
  const bool changes_something = request.is_upgrade || !request.only_reads();
  if (changes_something && !is_own_origin(request)) {
    return Verdict::kForeignOrigin;
  }
  return has_token(request) ? Verdict::kPass : Verdict::kNoToken;
}

std::string RequestGuard::cookie_for(const WebRequest& request) const {
  const auto told = request.query_value("token");
  if (token_.empty() || !told || !is_token(*told)) {
    return {};
  }
  return cookie_name() + "=" + token_ + "; Path=/; HttpOnly; SameSite=Strict";
}

bool RequestGuard::is_own_host(const WebRequest& request) const {
  const auto text = request.value_of("Host");
  const auto host = text ? HostAndPort::parse(*text) : std::nullopt;
  if (!host || host->port != port_) {
    return false;
  }
  const auto literal = IpLiteral::parse(host->host);
  if (!literal) {
    return host->host == "localhost";
  }
  return literal->is_loopback() || *literal == address_ || address_.is_any();
}

bool RequestGuard::is_own_origin(const WebRequest& request) const {
  const auto origins = request.values_of("Origin");
  if (origins.empty()) {
    return true;
  }
  const auto host_text = request.value_of("Host");
  const auto host = host_text ? HostAndPort::parse(*host_text) : std::nullopt;
  std::string_view origin = origins.front();
  constexpr std::string_view kScheme = "http://";
  if (origins.size() > 1 || !host || !origin.starts_with(kScheme)) {
    return false;
  }
  origin.remove_prefix(kScheme.size());
  return HostAndPort::parse(origin) == host;
}

bool RequestGuard::has_token(const WebRequest& request) const {
  if (token_.empty()) {
    return true;
  }
  if (const auto told = request.query_value("token")) {
    return is_token(*told);
  }
  const std::string begin = cookie_name() + "=";
  for (const auto header : request.values_of("Cookie")) {
    for (const auto cookie : elements_of(header, ';')) {
      if (cookie.starts_with(begin) && is_token(cookie.substr(begin.size()))) {
        return true;
      }
    }
  }
  return false;
}

bool RequestGuard::is_token(std::string_view text) const { return is_same_secret(text, token_); }

std::string RequestGuard::cookie_name() const {
  // A browser sends the cookies of one port of a host to all of them.
  return "echomap_" + std::to_string(port_);
}

bool is_same_secret(std::string_view a, std::string_view b) {
  unsigned difference = a.size() == b.size() ? 0U : 1U;
  for (std::size_t i = 0; i < a.size() && !b.empty(); ++i) {
    difference |= static_cast<unsigned char>(a[i] ^ b[i % b.size()]);
  }
  return difference == 0;
}

}  // namespace echomap::live_page
