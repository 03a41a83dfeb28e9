// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include "host/live_page/ip_literal.hpp"

namespace echomap::live_page {

/// An address that a server may listen on, by its number.
struct ListenAddress {
  std::string number;
  IpLiteral literal;
};

/// The address by that text. Throws console::CommandError where it is none, where others reach it
/// and no token keeps them out, and where the token could not stand in a URL.
ListenAddress listen_address(const std::string& address, const std::string& token);

/// What to open in a browser; with the token where there is one. Of a server that listens on every
/// address of the host it is one that others reach.
std::string page_url(const ListenAddress& address, std::uint16_t port, const std::string& token);

}  // namespace echomap::live_page
