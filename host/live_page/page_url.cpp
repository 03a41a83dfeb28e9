// SPDX-License-Identifier: MIT
#include "host/live_page/page_url.hpp"

#include <algorithm>
#include <ifaddrs.h>
#include <memory>

#include <arpa/inet.h>
#include <net/if.h>
#include <netinet/in.h>

#include "host/console/exit_code.hpp"

namespace echomap::live_page {
namespace {

[[noreturn]] void refuse(const std::string& what, const std::string& next) {
  throw console::CommandError(console::ExitCode::kUsage, what + "\n  next: " + next);
}

bool is_word(const std::string& text) {
  return std::all_of(text.begin(), text.end(), [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '-' ||
           c == '_';
  });
}

/// The number of an interface's IPv4 address; empty where it has none that others reach.
std::string number_of(const ifaddrs& interface) {
  const bool is_up = (interface.ifa_flags & IFF_UP) != 0;
  const bool is_loopback = (interface.ifa_flags & IFF_LOOPBACK) != 0;
  if (interface.ifa_addr == nullptr || interface.ifa_addr->sa_family != AF_INET || !is_up ||
      is_loopback) {
    return {};
  }
  const auto* address = reinterpret_cast<const sockaddr_in*>(interface.ifa_addr);
  char text[INET_ADDRSTRLEN] = "";
  ::inet_ntop(AF_INET, &address->sin_addr, text, sizeof text);
  return text;
}

/// One by which others reach this host, else the loopback's.
std::string number_for_others() {
  ifaddrs* all = nullptr;
  if (::getifaddrs(&all) != 0) {
    return "127.0.0.1";
  }
  const std::unique_ptr<ifaddrs, decltype(&::freeifaddrs)> owner(all, &::freeifaddrs);
  for (const ifaddrs* each = all; each != nullptr; each = each->ifa_next) {
    if (std::string number = number_of(*each); !number.empty()) {
      return number;
    }
  }
  return "127.0.0.1";
}

}  // namespace

ListenAddress listen_address(const std::string& address, const std::string& token) {
  const std::string number = address == "localhost" ? "127.0.0.1" : address;
  const auto literal = IpLiteral::parse(number);
  if (!literal) {
    refuse("'" + address + "' is no address to listen on",
           "name one by its number: 127.0.0.1, or 0.0.0.0 for every one of this host");
  }
  if (token.empty() && !literal->is_loopback()) {
    refuse("others reach " + number + ", and no token keeps them out",
           "listen on 127.0.0.1, or give a token");
  }
  if (!is_word(token)) {
    refuse("a token has other characters than letters, digits, - and _", "make another one");
  }
  return {number, *literal};
}

std::string page_url(const ListenAddress& address, std::uint16_t port, const std::string& token) {
  std::string host = address.literal.is_any() ? number_for_others() : address.number;
  if (host.find(':') != std::string::npos) {
    host = "[" + host + "]";
  }
  const std::string page = "http://" + host + ":" + std::to_string(port) + "/";
  return token.empty() ? page : page + "?token=" + token;
}

}  // namespace echomap::live_page
