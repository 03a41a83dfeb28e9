// SPDX-License-Identifier: MIT
#include "host/broker/credentials.hpp"

#include <limits>

#include <fmt/format.h>

#include "host/files/atomic_file.hpp"
#include "host/files/toml_reader.hpp"
#include "host/mqtt/fleet_name.hpp"

namespace echomap::broker {
namespace {

/// A basic string of TOML.
std::string toml_text(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      quoted += '\\';
    }
    quoted += c;
  }
  return quoted + "\"";
}

std::string name_of(const files::TomlReader& reader, const std::string& key) {
  const std::string name = reader.text(key);
  if (!mqtt::is_fleet_name(name)) {
    reader.fail(key, fmt::format("{} = '{}' is no name: 1 to 32 of a-z, 0-9, _ and -", key, name));
  }
  return name;
}

}  // namespace

void write_credentials(const std::filesystem::path& file, const Credentials& credentials) {
  std::string text = fmt::format(
      "# Whoever has this file can connect as {}.\n"
      "fleet = {}\nhost = {}\nport = {}\nuser = {}\npassword = {}\n",
      credentials.user,
      toml_text(credentials.fleet),
      toml_text(credentials.host),
      credentials.port,
      toml_text(credentials.user),
      toml_text(credentials.password));
  if (!credentials.ca_file.empty()) {
    text += fmt::format("ca = {}\n", toml_text(credentials.ca_file.string()));
  }
  files::write_text_file(file, text, files::Readers::kOwner);
}

Credentials read_credentials(const std::filesystem::path& file) {
  const auto reader = files::TomlReader::load(file);
  Credentials credentials;
  credentials.fleet = name_of(reader, "fleet");
  credentials.host = reader.text("host");
  const std::int64_t port = reader.integer("port");
  if (port < 1 || port > std::numeric_limits<std::uint16_t>::max()) {
    reader.fail("port", fmt::format("port = {} is outside 1 .. 65535", port));
  }
  credentials.port = static_cast<std::uint16_t>(port);
  credentials.user = name_of(reader, "user");
  credentials.password = reader.text("password");
  const std::filesystem::path ca_file = reader.text_or("ca", "");
  credentials.ca_file = ca_file.empty() ? ca_file : file.parent_path() / ca_file;
  reader.reject_unknown_keys();
  return credentials;
}

mqtt::ConnectionParams connection_params(const Credentials& credentials) {
  mqtt::ConnectionParams params;
  params.host = credentials.host;
  params.port = credentials.port;
  params.client_id = credentials.user;
  params.user = credentials.user;
  params.password = credentials.password;
  params.ca_file = credentials.ca_file;
  return params;
}

}  // namespace echomap::broker
