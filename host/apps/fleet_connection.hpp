// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "host/broker/credentials.hpp"
#include "host/fleet/exchange_statistics.hpp"
#include "host/mqtt/connection.hpp"

namespace echomap::apps {

/// A member's connection to its fleet's broker, and as whom it is made.
struct FleetConnection {
  broker::Credentials credentials;
  std::unique_ptr<mqtt::Connection> bus;
};

/// Connects as the member whose credentials are in that file, and waits until the broker has
/// accepted. Throws files::ConfigError for the file, and CommandError 1 where the broker does not
/// answer or refuses.
FleetConnection connect_to_fleet(const std::filesystem::path& credentials,
                                 const std::optional<mqtt::LastWill>& will = std::nullopt);

/// What becomes of the connection of a robot that drives meanwhile: warns once of each change.
class ConnectionNews {
 public:
  void tell(const mqtt::Connection& bus);

 private:
  bool is_connected_ = true;
  mqtt::Reason refused_ = mqtt::Reason::kNone;
};

/// Messages of a fleet that were refused, by the names of their reasons; only what there was.
std::map<std::string, std::size_t> refused_by_reason(const fleet::ReceptionStatistics& statistics);

/// Warns of those that tell of a fault; what was kept of before is refused in any fleet.
void warn_of_refused(const fleet::ReceptionStatistics& statistics);

}  // namespace echomap::apps
