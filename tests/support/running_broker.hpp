// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
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

/// True when the broker has answered all that was published at least once.
inline bool is_acknowledged(mqtt::Connection& connection) {
  std::vector<mqtt::Message> heard;
  return serve_until(connection, heard, [&] { return connection.unacknowledged() == 0; });
}

/// A connection that is there and has subscribed when this is made, and all that it has heard.
class Client {
 public:
  /// Throws where there is no connection within a minute.
  explicit Client(const mqtt::ConnectionParams& params, const std::string& filter = "")
      : connection_(std::make_unique<mqtt::Connection>(params)) {
    if (!filter.empty()) {
      connection_->subscribe(filter);
    }
    const std::size_t filters = filter.empty() ? 0 : 1;
    if (!serve_until([&] {
          return connection_->is_connected() && connection_->statistics().subscribed == filters;
        })) {
      throw std::runtime_error("no connection: " + std::string(text_of(connection_->reason())));
    }
  }

  mqtt::Connection* operator->() { return connection_.get(); }
  mqtt::Connection& operator*() { return *connection_; }
  const std::vector<mqtt::Message>& heard() const { return heard_; }
  bool serve_until(const std::function<bool()>& condition) {
    return tests::serve_until(*connection_, heard_, condition);
  }
  bool is_acknowledged() {
    return serve_until([&] { return connection_->unacknowledged() == 0; });
  }
  /// All that it has heard, once this payload is among it; nothing where it is not within a minute.
  std::vector<mqtt::Message> heard_until(const std::string& payload) {
    const auto is_it = [&](const mqtt::Message& each) { return each.payload == payload; };
    const bool has_come =
        serve_until([&] { return std::any_of(heard_.begin(), heard_.end(), is_it); });
    return has_come ? heard_ : std::vector<mqtt::Message>();
  }

 private:
  std::unique_ptr<mqtt::Connection> connection_;
  std::vector<mqtt::Message> heard_;
};

}  // namespace echomap::tests
