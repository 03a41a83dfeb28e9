// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <initializer_list>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "host/broker/broker.hpp"
#include "host/mqtt/connection.hpp"
#include "tests/support/eventually.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::tests {

/// Settings of a broker on loopback with these users.
inline broker::BrokerSettings broker_settings(std::initializer_list<std::string> users) {
  broker::BrokerSettings settings;
  settings.fleet = "lab";
  for (const std::string& user : users) {
    settings.users.push_back({user, broker::random_password()});
  }
  return settings;
}

/// A real broker in a folder of its own.
class RunningBroker {
 public:
  explicit RunningBroker(const broker::BrokerSettings& settings)
      : broker_(settings, folder_ / "broker") {}

  broker::Broker& operator*() { return broker_; }
  broker::Broker* operator->() { return &broker_; }

  /// Parameters of one of its users that tries again soon.
  mqtt::ConnectionParams params(const std::string& user) const {
    mqtt::ConnectionParams params = broker::connection_params(broker_.credentials(user));
    params.backoff = {0.01, 0.05, 2.0, 0.0, 5.0};
    return params;
  }

 private:
  ScratchFolder folder_;
  broker::Broker broker_;
};

/// Serves a connection until the condition holds, and adds to `heard` what comes. False after a
/// minute.
inline bool serve_until(mqtt::MessageBus& bus,
                        std::vector<mqtt::Message>& heard,
                        const std::function<bool()>& condition) {
  return eventually([&] {
    for (mqtt::Message& message : bus.take()) {
      heard.push_back(std::move(message));
    }
    return condition();
  });
}

/// What comes until a payload is among it; nothing where it does not within a minute.
inline std::vector<mqtt::Message> heard_until(mqtt::MessageBus& bus, const std::string& payload) {
  std::vector<mqtt::Message> heard;
  const bool has_come =
      serve_until(bus, heard, [&] { return !heard.empty() && heard.back().payload == payload; });
  return has_come ? heard : std::vector<mqtt::Message>();
}

/// A connection that is there when this returns. Throws where it is not within a minute.
inline std::unique_ptr<mqtt::Connection> connected(const mqtt::ConnectionParams& params,
                                                   const std::string& filter = "") {
  auto connection = std::make_unique<mqtt::Connection>(params);
  if (!filter.empty()) {
    connection->subscribe(filter);
  }
  std::vector<mqtt::Message> heard;
  if (!serve_until(*connection, heard, [&] { return connection->is_connected(); })) {
    throw std::runtime_error("no connection: " + std::string(text_of(connection->reason())));
  }
  return connection;
}

/// True when the broker has answered all that was published at least once.
inline bool is_acknowledged(mqtt::Connection& connection) {
  std::vector<mqtt::Message> heard;
  return serve_until(connection, heard, [&] { return connection.unacknowledged() == 0; });
}

}  // namespace echomap::tests
