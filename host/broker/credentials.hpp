// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "host/mqtt/connection.hpp"

namespace echomap::broker {

/// What a member of a fleet needs to connect to its broker.
struct Credentials {
  std::string fleet;
  std::string host;
  std::uint16_t port = 1883;
  std::string user;
  std::string password;
  std::filesystem::path ca_file;  ///< Empty: plain TCP.
};

/// Writes them as TOML that only this user can read. Throws files::FileError.
void write_credentials(const std::filesystem::path& file, const Credentials& credentials);

/// Reads such a file; a CA that it names without a folder is beside it. Throws files::ConfigError.
Credentials read_credentials(const std::filesystem::path& file);

/// A connection as this member.
mqtt::ConnectionParams connection_params(const Credentials& credentials);

}  // namespace echomap::broker
