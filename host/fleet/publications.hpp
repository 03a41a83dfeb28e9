// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
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

/// How much a message is worth where there is more to send than the budget allows.
enum class Worth : std::uint8_t {
  kUrgent,  ///< Presence, poses, claims, questions.
  kGraph,   ///< Graphs and alignments.
  kObject,  ///< Objects and the manifest.
  kRelay,   ///< What robots that are gone have told.
};
inline constexpr std::size_t kWorths = 4;

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
/// this connection, and is sent again where it has not. What waits shares the budget by worth, as
/// in start-time fair queueing (Goyal, Vin and Cheng 1996): a pose overtakes a hundred objects, and
/// objects get their share of a flood of claims. Of one worth the first one goes first.
class Publications {
 public:
  /// Gives a body its bytes; empty where it does not fit into a message.
  using Encode = std::function<std::optional<std::string>(const fleet_messages::MessageBody&)>;

  explicit Publications(const FleetExchangeParams& params);

  /// Publishes on a topic, in place of what was there and behind all that waits. What is not
  /// retained is forgotten once sent.
  void put(const fleet_messages::FleetTopic& topic, PublicationContent content, Worth worth);
  /// Notes what was published on a topic before this robot's host has started. A body gets a new
  /// counter where it is sent again.
  void restore(const fleet_messages::FleetTopic& topic,
               PublicationContent content,
               std::string payload,
               Worth worth);
  /// Sends what is there once more, unless it was sent a short time ago. False where there is
  /// nothing.
  bool repeat(const std::string& topic, double now_s);
  /// The same for all that is on topics of such kinds.
  void repeat_all(bool (*is_wanted)(fleet_messages::TopicKind), double now_s);
  /// All that bears a boot id, with the one of now.
  void say_again();
  /// Takes back what is there: the broker is to forget it.
  void withdraw(const std::string& topic);
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
    Worth worth = Worth::kUrgent;
    std::uint64_t place = 0;  ///< In the queue of its worth; 0 where it does not wait.
    bool is_retained = false;
    bool is_changed = false;  ///< The content is newer than the payload.
    bool is_confirmed = false;
    bool is_withdrawn = false;
    bool is_restored = false;  ///< The payload is of before the host's start.
    std::optional<double> sent_s;
  };
  using Entries = std::map<std::string, Entry>;

  /// Those of one worth that wait.
  struct Queue {
    std::map<std::uint64_t, std::string> topics;  ///< By place.
    double virtual_bytes = 0.0;                   ///< Sent so far, over the weight.
  };

  void let_wait(const std::string& topic, Entry& entry);
  void stop_waiting(Entry& entry);
  /// The queue whose turn it is; null where nothing waits.
  Queue* next_queue();
  /// Whether the entry has a payload to send.
  bool prepare(Entry& entry, const Encode& encode);
  void note_sent(Queue& queue, const std::string& topic, const Entry& entry);

  double compare_after_s_;
  double confirm_within_s_;
  double answer_period_s_;
  ByteBudget budget_;
  double connected_s_ = 0.0;
  Entries entries_;
  std::array<Queue, kWorths> queues_;
  std::uint64_t last_place_ = 0;
  PublicationStatistics statistics_;
};

}  // namespace echomap::fleet
