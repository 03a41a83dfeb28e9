// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace echomap::broker {

/// Files of a broker that speaks TLS.
struct Certificates {
  std::filesystem::path ca;  ///< What a client needs to know the broker by.
  std::filesystem::path server;
  std::filesystem::path server_key;
};

/// Makes a CA of its own in `folder`, unless there is one, and a certificate for the hosts by it:
/// keys on the curve P-256, SHA-256, host names and addresses as subjectAltName (RFC 5280 and
/// 6125). A CA that stays is known to robots that have its certificate. Throws
/// console::CommandError where openssl is missing or fails.
Certificates make_certificates(const std::filesystem::path& folder,
                               const std::string& fleet,
                               const std::vector<std::string>& hosts);

}  // namespace echomap::broker
