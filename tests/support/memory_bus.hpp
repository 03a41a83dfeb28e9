// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "host/mqtt/last_will.hpp"
#include "host/mqtt/message_bus.hpp"

namespace echomap::tests {

class MemoryBus;

/// How a broker in memory treats what is published.
struct MemoryBrokerParams {
  std::uint32_t seed = 1;
  /// Longest delay of a delivery, seconds, drawn evenly; a client's deliveries keep their order.
  double max_delay_s = 0.0;
  /// Share of deliveries that never come, of both kinds: a broker acknowledges, and drops what does
  /// not fit into a queue.
  double loss_share = 0.0;
  /// Share of deliveries at least once that come twice.
  double repeat_share = 0.0;
  std::size_t max_payload_bytes = std::size_t{256} << 10;
};

/// A broker in memory, of one thread, whose time and losses are the test's: with one seed and one
/// order of calls every client gets the same. It outlives its clients.
class MemoryBroker {
 public:
  explicit MemoryBroker(const MemoryBrokerParams& params = {});

  /// A client of this name, which connects at its first take().
  std::unique_ptr<MemoryBus> client(const std::string& name,
                                    std::optional<mqtt::LastWill> will = std::nullopt);

  /// What is due by then can be taken.
  void advance_to(double now_s) { now_s_ = now_s; }
  double now_s() const { return now_s_; }

  /// The client's connection ends, its will is published, and it gets none before resume().
  void cut(const std::string& name);
  void resume(const std::string& name);
  /// All connections end and no will is published; clients come back at their next take(). Of the
  /// retained messages a share is lost, as by kill -9.
  void restart(double lost_share = 0.0);

  /// What a client has handed over so far, topics and payloads, bytes.
  std::size_t published_bytes(const std::string& name) const;
  /// Deliveries that the broker has dropped.
  std::size_t lost() const { return lost_; }
  /// Retained payloads by topic.
  const std::map<std::string, std::string>& retained() const { return retained_; }

 private:
  friend class MemoryBus;

  void join(MemoryBus& client);
  void leave(MemoryBus& client);
  void accept(const std::string& from,
              const std::string& topic,
              std::string_view payload,
              mqtt::Delivery delivery,
              bool retain);
  void deliver(MemoryBus& client, mqtt::Message message, mqtt::Delivery delivery);
  void send_retained(MemoryBus& client, const std::string& filter);
  bool happens(double chance) { return even() < chance; }
  double even() { return static_cast<double>(random_()) / 4294967296.0; }

  MemoryBrokerParams params_;
  std::mt19937 random_;
  double now_s_ = 0.0;
  std::map<std::string, MemoryBus*> clients_;
  std::map<std::string, std::string> retained_;
  std::map<std::string, std::size_t> published_bytes_;
  std::size_t lost_ = 0;
};

/// A client of a broker in memory. It hears itself, as an MQTT client does.
class MemoryBus final : public mqtt::MessageBus {
 public:
  MemoryBus(MemoryBroker& broker, std::string name, std::optional<mqtt::LastWill> will);
  /// Without a goodbye: the will is published.
  ~MemoryBus() override;
  MemoryBus(const MemoryBus&) = delete;
  MemoryBus& operator=(const MemoryBus&) = delete;

  bool publish(const std::string& topic,
               std::string_view payload,
               mqtt::Delivery delivery,
               bool retain) override;
  void subscribe(const std::string& filter) override;
  std::vector<mqtt::Message> take() override;
  bool is_connected() const override { return is_connected_; }
  std::size_t connections() const override { return connections_; }
  /// Ends the connection in order: no will is published.
  void disconnect();

 private:
  friend class MemoryBroker;

  struct Unsent {
    std::string topic;
    std::string payload;
    bool retain;
  };

  struct Due {
    double at_s;
    mqtt::Message message;
  };

  void connect();
  void drop_connection();

  MemoryBroker& broker_;
  std::string name_;
  std::optional<mqtt::LastWill> will_;
  bool is_connected_ = false;
  bool is_cut_ = false;
  std::size_t connections_ = 0;
  std::vector<std::string> filters_;
  std::deque<Unsent> unsent_;
  std::deque<Due> due_;
};

/// Whether a topic filter of MQTT, with `+` and `#`, takes a topic.
bool topic_matches(std::string_view filter, std::string_view topic);

}  // namespace echomap::tests
