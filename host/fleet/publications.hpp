// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "host/fleet/byte_budget.hpp"
#include "host/fleet/exchange_params.hpp"
#include "host/fleet_messages/messages.hpp"
#include "host/mqtt/message_bus.hpp"

namespace echomap::fleet {

/// What is to be published on a topic: bytes that never change, or a body, which gets its counter
/// when it is sent.
using PublicationContent = std::variant<std::string, fleet_messages::MessageBody>;

/// What has been sent so far.
struct PublicationStatistics {
  std::size_t messages = 0;
  std::size_t bytes = 0;            ///< Of MQTT packets.
  std::size_t published_again = 0;  ///< The broker did not have them any more.
  std::size_t too_large = 0;        ///< For a message or for the broker; they are not sent.
};

/// What a robot is the source of, and what of it waits to be sent. The broker's acknowledgement is
/// no promise: a message that is retained counts as published when the robot has heard it back on
/// this connection, and is sent again where it has not. What waits goes by deadline, the earliest
/// first, so that a pose overtakes an object that has come lately, and nothing waits for ever.
class Publications {
 public:
  /// Gives a body its bytes; empty where it does not fit into a message.
  using Encode = std::function<std::optional<std::string>(const fleet_messages::MessageBody&)>;

  explicit Publications(const FleetExchangeParams& params);

  /// Publishes on a topic, in place of what was there. It waits at least until it is due where
  /// there is much to send: `patience_s` from now. What is not retained is forgotten once sent.
  void put(const fleet_messages::FleetTopic& topic,
           PublicationContent content,
           double patience_s,
           double now_s);
  /// Notes what was published on a topic before this robot's host has started.
  void restore(const fleet_messages::FleetTopic& topic, std::string payload);
  /// Sends what is there once more, unless it was sent a short time ago. False where there is
  /// nothing.
  bool repeat(const std::string& topic, double now_s);
  /// The same for all that is on topics of such kinds.
  void repeat_all(bool (*is_wanted)(fleet_messages::TopicKind), double now_s);
  /// Takes back what is there: the broker is to forget it.
  void withdraw(const std::string& topic, double now_s);
  /// The broker has it.
  void confirm(const std::string& topic, std::string_view payload);
  bool has(const std::string& topic) const { return entries_.contains(topic); }

  /// There is a new connection, and nobody knows what the broker has.
  void on_connected(double now_s);
  /// Lets wait what the broker should have sent back by now.
  void compare(double now_s);
  /// Publishes as much of what waits as the budget allows.
  void send(mqtt::MessageBus& bus, const Encode& encode, double now_s);

  std::size_t waiting() const;
  /// Retained messages that the broker has not sent back on this connection.
  std::size_t unconfirmed() const;
  /// Of the payloads that were sent last on topics of such kinds, since the host has started.
  std::vector<fleet_messages::ContentHash> sent_hashes(
      bool (*is_wanted)(fleet_messages::TopicKind)) const;
  const PublicationStatistics& statistics() const { return statistics_; }

 private:
  struct Entry {
    PublicationContent content;
    fleet_messages::TopicKind kind = fleet_messages::TopicKind::kPresence;
    std::string payload;  ///< As it was sent last.
    mqtt::Delivery delivery = mqtt::Delivery::kAtLeastOnce;
    bool is_retained = false;
    bool is_waiting = false;
    bool is_changed = false;  ///< The content is newer than the payload.
    bool is_confirmed = false;
    bool is_withdrawn = false;
    bool is_restored = false;  ///< The payload is of before the host's start.
    double patience_s = 0.0;
    double due_s = 0.0;
    std::optional<double> sent_s;
  };
  using Entries = std::map<std::string, Entry>;

  void let_wait(Entry& entry, double now_s);
  Entries::iterator most_urgent();
  /// Whether the entry has a payload to send.
  bool prepare(Entry& entry, const Encode& encode);

  double compare_after_s_;
  double confirm_within_s_;
  double answer_period_s_;
  ByteBudget budget_;
  double connected_s_ = 0.0;
  Entries entries_;
  PublicationStatistics statistics_;
};

}  // namespace echomap::fleet
