// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace echomap::broker {

/// An account of a broker: a robot of the fleet, its hub, or the site that a bridge comes from.
struct BrokerUser {
  std::string name;
  std::string password;
};

/// A second broker, to which this one hands on what is closed of its fleet, not poses and claims.
struct SiteBridge {
  std::string host;
  std::uint16_t port = 1883;
  std::string region;  ///< The fleet of that broker; this site is one of its members.
  std::string site;    ///< Its account there.
  std::string password;
  std::filesystem::path ca_file;  ///< Of that broker; empty: plain TCP.
};

/// A Mosquitto broker of one fleet.
struct BrokerSettings {
  std::string fleet = "fleet";
  std::string address = "127.0.0.1";  ///< Where it listens: an address of this machine.
  std::uint16_t port = 0;             ///< 0: one that is free.
  std::vector<BrokerUser> users;      ///< Each may read the fleet and write below its own name.
  /// Of those, the one that may read all that the broker has.
  std::string hub = "hub";
  bool tls = false;
  /// Names and addresses that clients use for this machine, beside localhost and `address`: what
  /// its certificate is for. The first is in the credentials of members.
  std::vector<std::string> host_names;
  /// Largest payload, bytes: that of a fleet's messages.
  std::size_t max_payload_bytes = std::size_t{16} << 10;
  /// What waits for one client at most, bytes, four times 10,000 objects of 1.5 kB. Mosquitto keeps
  /// a message once, for however many it waits.
  std::size_t max_queued_bytes = std::size_t{64} << 20;
  int save_interval_s = 60;  ///< How often retained messages are written to disk; 0: at the end.
  std::optional<SiteBridge> bridge;
};

/// Throws console::CommandError kConfigInvalid with the field, its value and what it may be.
void validate(const BrokerSettings& settings);

/// A password by the system's random numbers: 128 bits, as hexadecimal digits. Throws
/// std::system_error.
std::string random_password();

}  // namespace echomap::broker
