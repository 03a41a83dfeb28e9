// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host/mqtt/backoff.hpp"
#include "host/mqtt/last_will.hpp"
#include "host/mqtt/message_bus.hpp"
#include "host/mqtt/outbox.hpp"
#include "host/mqtt/reason.hpp"

// The client of libmosquitto.
struct mosquitto;

namespace echomap::mqtt {

/// Address and identity of a connection.
struct ConnectionParams {
  /// Address of the broker. A name is resolved at every attempt, for which take() waits.
  std::string host = "127.0.0.1";
  std::uint16_t port = 1883;
  std::string client_id;  ///< At least one character; our brokers use the user's name.
  std::string user;       ///< Empty: none is sent.
  std::string password;
  std::filesystem::path ca_file;  ///< TLS, with a certificate by this CA; empty: plain TCP.
  std::optional<LastWill> will;
  /// Seconds without a packet after which the broker is pinged, 5 to 65535; a connection that is
  /// silent is given up within twice this time.
  int keep_alive_s = 10;
  double answer_s = 10.0;  ///< How long the broker may take to accept, seconds.
  /// Deliveries at least once that may be unacknowledged, 1 to 65535: 500 a second on a line with 2
  /// s of delay.
  int receive_maximum = 1000;
  int send_maximum = 100;  ///< The same for published messages; the broker may allow fewer.
  OutboxParams outbox;
  BackoffParams backoff;
  std::uint32_t seed = 1;  ///< Seed of the jitter; differs between the members of a fleet.
};

/// Counts of a connection so far.
struct ConnectionStatistics {
  std::size_t published = 0;  ///< Sent, of both kinds; those at least once may be sent twice.
  std::size_t acked = 0;      ///< At least once: accepted by the broker, which is no promise.
  std::size_t refused = 0;    ///< At least once: rejected by the broker.
  std::size_t too_large = 0;  ///< Not sent: larger than the broker accepts.
  std::size_t dropped = 0;    ///< Not sent: at most once without a connection, or a full outbox.
  std::size_t reconnects = 0;
  std::size_t failed_attempts = 0;
  std::size_t subscribed = 0;  ///< Acknowledged subscriptions, those after a reconnection, too.
  std::size_t received = 0;
  std::size_t published_bytes = 0;  ///< Topics and payloads.
  std::size_t received_bytes = 0;
};

/// A message that the broker has refused.
struct RefusedMessage {
  std::string topic;
  Reason reason = Reason::kNone;
};

/// A client of an MQTT 5 broker, without a thread: take() serves the socket and never blocks on it.
/// It connects by itself, and again after every end, with a clean start: retained messages come
/// again, and what was published at least once and is not acknowledged is sent again.
class Connection final : public MessageBus {
 public:
  /// Nothing is sent before the first take(). Throws std::invalid_argument where a parameter is out
  /// of its range, and std::runtime_error where the CA's file cannot be read.
  explicit Connection(const ConnectionParams& params);
  /// Drops the connection, so that the broker publishes the will.
  ~Connection() override;
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  bool publish(const std::string& topic,
               std::string_view payload,
               Delivery delivery,
               bool retain) override;
  void subscribe(const std::string& filter) override;
  std::vector<Message> take() override;
  bool is_connected() const override { return is_connected_; }
  std::size_t connections() const override { return connections_; }

  /// Disconnects: the broker publishes no will, and take() does not connect again.
  void disconnect();
  /// Why there is no connection, or why the last one has ended.
  Reason reason() const { return reason_; }
  /// Whether another client has ever connected as the same user.
  bool was_taken_over() const { return was_taken_over_; }
  /// The message that was refused last.
  const std::optional<RefusedMessage>& last_refused() const { return last_refused_; }
  const ConnectionStatistics& statistics() const { return statistics_; }
  /// Number of messages that are not acknowledged yet.
  std::size_t unacknowledged() const { return outbox_.size(); }
  /// Largest packet that the broker accepts, bytes; empty where it names none or is not known yet.
  std::optional<std::size_t> max_packet_bytes() const { return max_packet_bytes_; }

 private:
  using Clock = std::chrono::steady_clock;

  /// Callbacks of libmosquitto.
  struct Callbacks;

  struct Destroy {
    void operator()(mosquitto* client) const;
  };

  std::unique_ptr<mosquitto, Destroy> make_client();
  void connect(Clock::time_point now);
  void serve(Clock::time_point now);
  bool serve_once(Clock::time_point now);
  void note_accepted();
  void send_waiting();
  bool is_too_large(std::string_view topic, std::string_view payload) const;
  bool has_bytes() const;
  void end(Clock::time_point now, Reason reason);
  Reason reason_of_error(int error) const;

  ConnectionParams params_;
  Outbox outbox_;
  Backoff backoff_;
  std::unique_ptr<mosquitto, Destroy> client_;  ///< Of one connection or attempt.
  std::vector<std::string> filters_;
  std::vector<Message> arrived_;
  ConnectionStatistics statistics_;
  std::optional<RefusedMessage> last_refused_;
  std::optional<std::size_t> max_packet_bytes_;
  std::size_t send_window_ = 0;
  std::size_t connections_ = 0;
  std::size_t events_ = 0;  ///< Packets of the broker that were noticed.
  Reason reason_ = Reason::kNone;
  Reason reported_reason_ = Reason::kNone;  ///< Reported by the broker for this connection.
  Clock::time_point begun_{};
  bool was_taken_over_ = false;
  bool is_connected_ = false;
  bool has_ended_ = false;        ///< By the broker or the network, in a callback.
  bool is_disconnected_ = false;  ///< By disconnect().
};

}  // namespace echomap::mqtt
