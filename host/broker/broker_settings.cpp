// SPDX-License-Identifier: MIT
#include "host/broker/broker_settings.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <set>
#include <string_view>
#include <system_error>

#include <fmt/format.h>
#include <sys/random.h>

#include "host/console/exit_code.hpp"
#include "host/mqtt/fleet_name.hpp"

namespace echomap::broker {
namespace {

[[noreturn]] void refuse(const std::string& message) {
  throw console::CommandError(console::ExitCode::kConfigInvalid, "broker: " + message);
}

void validate_name(const char* field, const std::string& name) {
  if (!mqtt::is_fleet_name(name)) {
    refuse(fmt::format("{} = '{}' is no name: 1 to 32 of a-z, 0-9, _ and - are", field, name));
  }
}

/// In Mosquitto's files a password ends with its line, and a colon ends a name.
void validate_password(const std::string& user, const std::string& password) {
  const bool is_printable =
      std::ranges::all_of(password, [](char c) { return c > ' ' && c < '\x7f' && c != ':'; });
  if (password.size() < 8 || password.size() > 64 || !is_printable) {
    refuse(fmt::format(
        "the password of {} is not 8 to 64 printable characters without space and colon", user));
  }
}

/// A name or an address: what the configuration and the certificate take as one word.
void validate_host(const char* field, const std::string& host) {
  const bool is_host = !host.empty() && host.size() <= 253 && std::ranges::all_of(host, [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
           std::string_view("-_.:").find(c) != std::string_view::npos;
  });
  if (!is_host) {
    refuse(fmt::format("{} = '{}' is no host name or address", field, host));
  }
}

void validate_bytes(const char* field, std::size_t bytes, std::size_t min, std::size_t max) {
  if (bytes < min || bytes > max) {
    refuse(fmt::format("{} = {} is outside {} .. {}", field, bytes, min, max));
  }
}

void validate_bridge(const SiteBridge& bridge) {
  validate_host("bridge.host", bridge.host);
  validate_name("bridge.region", bridge.region);
  validate_name("bridge.site", bridge.site);
  validate_password(bridge.site, bridge.password);
}

}  // namespace

void validate(const BrokerSettings& settings) {
  validate_name("fleet", settings.fleet);
  validate_name("hub", settings.hub);
  validate_host("address", settings.address);
  std::set<std::string> names;
  for (const BrokerUser& user : settings.users) {
    validate_name("user", user.name);
    validate_password(user.name, user.password);
    if (!names.insert(user.name).second) {
      refuse(fmt::format("two users have the name {}", user.name));
    }
  }
  for (const std::string& name : settings.host_names) {
    validate_host("host_names", name);
  }
  // Mosquitto takes packets of 256 MiB at most (MQTT 5, section 2.1.4).
  validate_bytes("max_payload_bytes", settings.max_payload_bytes, 1024, std::size_t{128} << 20);
  validate_bytes("max_queued_bytes",
                 settings.max_queued_bytes,
                 settings.max_payload_bytes,
                 std::size_t{1} << 40);
  if (settings.save_interval_s < 0) {
    refuse(fmt::format("save_interval_s = {} is below 0", settings.save_interval_s));
  }
  if (settings.bridge) {
    validate_bridge(*settings.bridge);
  }
}

std::string random_password() {
  std::array<unsigned char, 16> bytes{};
  if (::getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size())) {
    throw std::system_error(errno, std::generic_category(), "no random numbers");
  }
  std::string password;
  for (const unsigned char byte : bytes) {
    password += fmt::format("{:02x}", byte);
  }
  return password;
}

}  // namespace echomap::broker
