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

/// Priority of a message where there is more to send than the budget allows.
enum class Worth : std::uint8_t {
  kUrgent,  ///< Presence, poses, claims, requests.
  kGraph,   ///< Graphs and alignments.
  kObject,  ///< Objects and the manifest.
  kRelay,   ///< Messages of robots that are gone.
};
inline constexpr std::size_t kWorths = 4;

/// Content of a topic: bytes that never change, or a body, which gets its counter when it is sent.
using PublicationContent = std::variant<std::string, fleet_messages::MessageBody>;

/// Counts of the messages sent so far.
struct PublicationStatistics {
  std::size_t messages = 0;
  std::size_t bytes = 0;            ///< Of MQTT packets.
  std::size_t published_again = 0;  ///< Messages that the broker had lost.
  std::size_t too_large = 0;        ///< Not sent: too large for the format or the broker.
};

/// Messages that a robot is the source of, and the queue of those that wait to be sent. The
/// broker's acknowledgement is no promise: a retained message counts as published when the broker
/// has sent it back on this connection, and is sent again otherwise. Waiting messages share the
/// budget by worth, as in start-time fair queueing (Goyal, Vin and Cheng 1996): a pose overtakes a
/// hundred objects, and objects get their share of a flood of claims. Within one worth, the oldest
/// goes first.
class Publications {
 public:
  /// Encodes a body; empty where it does not fit into a message.
  using Encode = std::function<std::optional<std::string>(const fleet_messages::MessageBody&)>;

  explicit Publications(const FleetExchangeParams& params);

  /// Publishes on a topic, in place of its content so far and behind all that waits. Content that
  /// is not retained is forgotten once it is sent.
  void put(const fleet_messages::FleetTopic& topic, PublicationContent content, Worth worth);
  /// Records what was published on a topic before this robot's host started. A body gets a new
  /// counter where it is sent again.
  void restore(const fleet_messages::FleetTopic& topic,
               PublicationContent content,
               std::string payload,
               Worth worth);
  /// Sends the content of a topic again, unless it was sent a short time ago. False where the topic
  /// has none.
  bool repeat(const std::string& topic, double now_s);
  /// Sends the content of all topics of the wanted kinds again, as `repeat` does.
  void repeat_all(bool (*is_wanted)(fleet_messages::TopicKind), double now_s);
  /// Sends all bodies again, with the current boot id.
  void resend();
  /// Withdraws the content of a topic: the broker deletes it.
  void withdraw(const std::string& topic);
  /// Records that the broker has sent a payload back.
  void confirm(const std::string& topic, std::string_view payload);
  bool has(const std::string& topic) const { return entries_.contains(topic); }

  /// Handles a new connection: it is unknown what the broker has.
  void on_connected(double now_s);
  /// Queues what the broker should have sent back by now and has not.
  void compare(double now_s);
  /// Publishes as much of the queue as the budget allows.
  void send(mqtt::MessageBus& bus, const Encode& encode, double now_s);

  std::size_t waiting() const;
  /// Retained messages that the broker has not sent back on this connection.
  std::size_t unconfirmed() const;
  /// Hashes of the payloads that were sent last on topics of the wanted kinds, since the host's
  /// start.
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
    std::uint64_t place = 0;  ///< Place in the queue of its worth; 0 where it does not wait.
    bool is_retained = false;
    bool is_changed = false;  ///< The content is newer than the payload.
    bool is_confirmed = false;
    bool is_withdrawn = false;
    bool is_restored = false;  ///< The payload is from before the host's start.
    std::optional<double> sent_s;
  };
  using Entries = std::map<std::string, Entry>;

  /// Entries of one worth that wait.
  struct Queue {
    std::map<std::uint64_t, std::string> topics;  ///< By place.
    double virtual_bytes = 0.0;                   ///< Bytes sent so far, divided by the weight.
  };

  void let_wait(const std::string& topic, Entry& entry);
  void stop_waiting(Entry& entry);
  /// The queue whose turn it is; null where nothing waits.
  Queue* next_queue();
  /// Encodes the entry where it has changed. False where there is nothing to send.
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
