// SPDX-License-Identifier: MIT
#include "host/apps/fleet_connection.hpp"

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>
#include <thread>

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "host/apps/commands.hpp"
#include "host/console/interrupt.hpp"
#include "host/fleet_messages/refused_reason.hpp"

namespace echomap::apps {
namespace {

/// A broker on the same network answers within milliseconds.
constexpr std::chrono::seconds kBrokerPatience{10};

}  // namespace

FleetConnection connect_to_fleet(const std::filesystem::path& credentials,
                                 const std::optional<mqtt::LastWill>& will) {
  FleetConnection fleet{broker::read_credentials(credentials), nullptr};
  mqtt::ConnectionParams params = broker::connection_params(fleet.credentials);
  params.will = will;
  // Robots that lost the broker together do not come back at the same instant.
  params.seed = static_cast<std::uint32_t>(std::hash<std::string>{}(fleet.credentials.user));
  fleet.bus = std::make_unique<mqtt::Connection>(params);
  const auto end = std::chrono::steady_clock::now() + kBrokerPatience;
  while (true) {
    fleet.bus->take();
    if (fleet.bus->is_connected()) {
      return fleet;
    }
    const bool is_refused = fleet.bus->reason() == mqtt::Reason::kWrongPassword;
    if (is_refused || std::chrono::steady_clock::now() > end) {
      throw CommandError(
          ExitCode::kRuntimeError,
          fmt::format("{} the broker at {}:{}: {}\n  next: {}",
                      is_refused ? "refused by" : "no answer from",
                      params.host,
                      params.port,
                      mqtt::text_of(fleet.bus->reason()),
                      is_refused ? "use the credentials that `echomap fleet start` wrote, "
                                   "broker/members/NAME.toml"
                                 : "start it with `echomap fleet start`, or see its log, "
                                   "broker/mosquitto.log"));
    }
    if (console::interrupted()) {
      throw CommandError(ExitCode::kInterrupted, "interrupted");
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
}

std::map<std::string, std::size_t> refused_by_reason(const fleet::ReceptionStatistics& statistics) {
  std::map<std::string, std::size_t> refused;
  for (std::size_t i = 0; i < statistics.refused.size(); ++i) {
    if (statistics.refused[i] > 0) {
      refused[std::string(name_of(static_cast<fleet_messages::RefusedReason>(i)))] =
          statistics.refused[i];
    }
  }
  return refused;
}

void warn_of_refused(const fleet::ReceptionStatistics& statistics) {
  using fleet_messages::RefusedReason;
  std::map<std::string, std::size_t> refused = refused_by_reason(statistics);
  for (const RefusedReason usual : {RefusedReason::kReplayed, RefusedReason::kOldBoot}) {
    refused.erase(std::string(name_of(usual)));
  }
  for (const auto& [reason, count] : refused) {
    spdlog::warn("{} messages of the fleet were refused: {}", count, reason);
  }
}

void ConnectionNews::tell(const mqtt::Connection& bus) {
  if (bus.is_connected() != is_connected_) {
    is_connected_ = bus.is_connected();
    if (is_connected_) {
      spdlog::warn("connected with the broker again");
    } else {
      spdlog::warn("no connection with the broker: {}", mqtt::text_of(bus.reason()));
    }
  }
  const std::optional<mqtt::RefusedMessage>& last = bus.last_refused();
  if (last && last->reason != refused_) {
    refused_ = last->reason;
    spdlog::warn("the broker refuses {}: {}", last->topic, mqtt::text_of(refused_));
  }
}

}  // namespace echomap::apps
