// SPDX-License-Identifier: MIT
#include "host/mqtt/connection.hpp"

#include <algorithm>
#include <cerrno>
#include <limits>
#include <mosquitto.h>
#include <mqtt_protocol.h>
#include <poll.h>
#include <stdexcept>
#include <utility>

#include "host/mqtt/packet_size.hpp"

namespace echomap::mqtt {
namespace {

/// Packets of one take(), some 25 ms, so that it ends where they come faster than they are read.
constexpr int kMaxPasses = 500;
constexpr int kAtLeastOnce = 1;

/// libmosquitto is set up once and stays so: others of this process may use it, too.
void set_up_library() {
  static const int result = mosquitto_lib_init();
  if (result != MOSQ_ERR_SUCCESS) {
    throw std::runtime_error("libmosquitto cannot be set up");
  }
}

void validate_connection_field(const char* field, int value, int min, int max) {
  if (value < min || value > max) {
    throw std::invalid_argument("MQTT connection: " + std::string(field) + " = " +
                                std::to_string(value) + " is outside " + std::to_string(min) +
                                " .. " + std::to_string(max));
  }
}

const ConnectionParams& validated(const ConnectionParams& params) {
  constexpr int kMax = std::numeric_limits<std::uint16_t>::max();
  if (params.client_id.empty()) {
    throw std::invalid_argument("MQTT connection: client_id is empty");
  }
  validate_connection_field("keep_alive_s", params.keep_alive_s, 5, kMax);
  validate_connection_field("receive_maximum", params.receive_maximum, 1, kMax);
  validate_connection_field("send_maximum", params.send_maximum, 1, kMax);
  return params;
}

int size_of(std::string_view payload) { return static_cast<int>(payload.size()); }

}  // namespace

struct Connection::Callbacks {
  static Connection& of(void* self) { return *static_cast<Connection*>(self); }

  static void on_connect(
      mosquitto* /*client*/, void* self, int code, int /*flags*/, const mosquitto_property* list) {
    Connection& connection = of(self);
    ++connection.events_;
    if (code != 0) {
      connection.reported_reason_ = reason_of_connack(code);
      connection.has_ended_ = true;
      return;
    }
    std::uint32_t packet_bytes = 0;
    const bool is_limited =
        mosquitto_property_read_int32(list, MQTT_PROP_MAXIMUM_PACKET_SIZE, &packet_bytes, false) !=
        nullptr;
    connection.max_packet_bytes_ =
        is_limited ? std::optional<std::size_t>(packet_bytes) : std::nullopt;
    std::uint16_t window = std::numeric_limits<std::uint16_t>::max();
    mosquitto_property_read_int16(list, MQTT_PROP_RECEIVE_MAXIMUM, &window, false);
    connection.send_window_ =
        std::min<std::size_t>(window, static_cast<std::size_t>(connection.params_.send_maximum));
    connection.is_connected_ = true;
  }

  static void on_disconnect(mosquitto* /*client*/,
                            void* self,
                            int code,
                            const mosquitto_property* /*list*/) {
    Connection& connection = of(self);
    ++connection.events_;
    connection.has_ended_ = true;
    const Reason reported = reason_of_code(code);
    if (reported != Reason::kNone) {
      connection.reported_reason_ = reported;
    }
  }

  static void on_publish(
      mosquitto* /*client*/, void* self, int id, int code, const mosquitto_property* /*list*/) {
    Connection& connection = of(self);
    ++connection.events_;
    const auto message = connection.outbox_.take_answered(id);
    if (!message) {
      return;
    }
    const Reason reason = reason_of_code(code);
    if (reason == Reason::kNone) {
      ++connection.statistics_.acked;
    } else {
      ++connection.statistics_.refused;
      connection.last_refused_ = RefusedMessage{message->topic, reason};
    }
  }

  static void on_message(mosquitto* /*client*/,
                         void* self,
                         const mosquitto_message* message,
                         const mosquitto_property* /*list*/) {
    Connection& connection = of(self);
    ++connection.events_;
    ++connection.statistics_.received;
    const auto* bytes = static_cast<const char*>(message->payload);
    const auto size = static_cast<std::size_t>(message->payloadlen);
    std::string payload = size == 0 ? std::string() : std::string(bytes, size);
    std::string topic = message->topic;
    connection.statistics_.received_bytes += topic.size() + size;
    connection.arrived_.push_back({std::move(topic), std::move(payload), message->retain});
  }

  static void on_subscribe(mosquitto* /*client*/,
                           void* self,
                           int /*id*/,
                           int /*count*/,
                           const int* /*granted*/,
                           const mosquitto_property* /*list*/) {
    ++of(self).events_;
    ++of(self).statistics_.subscribed;
  }
};

void Connection::Destroy::operator()(mosquitto* client) const { mosquitto_destroy(client); }

Connection::Connection(const ConnectionParams& params)
    : params_(validated(params)), outbox_(params.outbox), backoff_(params.backoff, params.seed) {
  set_up_library();
  make_client();
}

Connection::~Connection() {
  if (is_connected_) {
    mosquitto_disconnect_v5(client_.get(), MQTT_RC_DISCONNECT_WITH_WILL_MSG, nullptr);
  }
}

std::unique_ptr<mosquitto, Connection::Destroy> Connection::make_client() {
  std::unique_ptr<mosquitto, Destroy> client(mosquitto_new(params_.client_id.c_str(), true, this));
  if (!client) {
    throw std::runtime_error("MQTT connection: no client of the name " + params_.client_id);
  }
  mosquitto* raw = client.get();
  mosquitto_int_option(raw, MOSQ_OPT_PROTOCOL_VERSION, MQTT_PROTOCOL_V5);
  mosquitto_int_option(raw, MOSQ_OPT_TCP_NODELAY, 1);
  mosquitto_int_option(raw, MOSQ_OPT_RECEIVE_MAXIMUM, params_.receive_maximum);
  mosquitto_int_option(raw, MOSQ_OPT_SEND_MAXIMUM, params_.send_maximum);
  mosquitto_connect_v5_callback_set(raw, &Callbacks::on_connect);
  mosquitto_disconnect_v5_callback_set(raw, &Callbacks::on_disconnect);
  mosquitto_publish_v5_callback_set(raw, &Callbacks::on_publish);
  mosquitto_message_v5_callback_set(raw, &Callbacks::on_message);
  mosquitto_subscribe_v5_callback_set(raw, &Callbacks::on_subscribe);
  if (!params_.user.empty()) {
    mosquitto_username_pw_set(raw, params_.user.c_str(), params_.password.c_str());
  }
  if (params_.will) {
    const LastWill& will = *params_.will;
    const int error = mosquitto_will_set_v5(raw,
                                            will.topic.c_str(),
                                            size_of(will.payload),
                                            will.payload.data(),
                                            kAtLeastOnce,
                                            will.retain,
                                            nullptr);
    if (error != MOSQ_ERR_SUCCESS) {
      throw std::invalid_argument("MQTT connection: no will on the topic '" + will.topic + "'");
    }
  }
  if (!params_.ca_file.empty() &&
      mosquitto_tls_set(raw, params_.ca_file.c_str(), nullptr, nullptr, nullptr, nullptr) !=
          MOSQ_ERR_SUCCESS) {
    throw std::runtime_error("cannot read the broker's CA certificate " + params_.ca_file.string());
  }
  return client;
}

bool Connection::publish(const std::string& topic,
                         std::string_view payload,
                         Delivery delivery,
                         bool retain) {
  if (is_too_large(topic, payload)) {
    ++statistics_.too_large;
    return false;
  }
  if (delivery == Delivery::kAtLeastOnce) {
    statistics_.dropped += outbox_.push(topic, payload, retain);
    send_waiting();
    return true;
  }
  // What the line does not take would wait without a bound, and is old when it is sent.
  if (!is_connected_ || mosquitto_want_write(client_.get()) ||
      mosquitto_publish_v5(client_.get(),
                           nullptr,
                           topic.c_str(),
                           size_of(payload),
                           payload.data(),
                           0,
                           retain,
                           nullptr) != MOSQ_ERR_SUCCESS) {
    ++statistics_.dropped;
    return true;
  }
  ++statistics_.published;
  statistics_.published_bytes += topic.size() + payload.size();
  return true;
}

void Connection::subscribe(const std::string& filter) {
  if (mosquitto_sub_topic_check(filter.c_str()) != MOSQ_ERR_SUCCESS) {
    throw std::invalid_argument("no topic filter of MQTT: '" + filter + "'");
  }
  if (std::ranges::find(filters_, filter) == filters_.end()) {
    filters_.push_back(filter);
  }
  if (is_connected_) {
    mosquitto_subscribe(client_.get(), nullptr, filter.c_str(), kAtLeastOnce);
  }
}

std::vector<Message> Connection::take() {
  const auto now = Clock::now();
  if (!client_ && !is_disconnected_ && backoff_.is_due(now)) {
    connect(now);
  }
  if (client_) {
    serve(now);
  }
  return std::exchange(arrived_, {});
}

void Connection::disconnect() {
  is_disconnected_ = true;
  if (is_connected_) {
    mosquitto_disconnect_v5(client_.get(), MQTT_RC_NORMAL_DISCONNECTION, nullptr);
    end(Clock::now(), Reason::kNone);
  }
  client_.reset();
}

void Connection::connect(Clock::time_point now) {
  client_ = make_client();
  begun_ = now;
  reported_reason_ = Reason::kNone;
  has_ended_ = false;
  const int error = mosquitto_connect_bind_async(
      client_.get(), params_.host.c_str(), params_.port, params_.keep_alive_s, nullptr);
  if (error > 0) {
    end(now, reason_of_error(error));
  }
}

void Connection::serve(Clock::time_point now) {
  for (int pass = 0; pass < kMaxPasses; ++pass) {
    const std::size_t events_before = events_;
    if (!serve_once(now)) {
      return;
    }
    if (events_ == events_before && !has_bytes()) {
      break;
    }
  }
  const std::chrono::duration<double> limit(params_.answer_s);
  if (!is_connected_ && now - begun_ > limit) {
    end(now, Reason::kSilent);
  }
}

/// False where that has ended the connection.
bool Connection::serve_once(Clock::time_point now) {
  const bool was_connected = is_connected_;
  const int error = mosquitto_loop(client_.get(), 0, 1);
  if (error != MOSQ_ERR_SUCCESS || has_ended_) {
    end(now, reason_of_error(error));
    return false;
  }
  if (is_connected_ && !was_connected) {
    backoff_.note_connected(now);
    note_accepted();
  }
  send_waiting();
  return true;
}

void Connection::note_accepted() {
  reason_ = Reason::kNone;
  ++connections_;
  statistics_.reconnects = connections_ - 1;
  for (const std::string& filter : filters_) {
    mosquitto_subscribe(client_.get(), nullptr, filter.c_str(), kAtLeastOnce);
  }
}

void Connection::send_waiting() {
  const OutgoingMessage* message = is_connected_ ? outbox_.next() : nullptr;
  for (; message != nullptr && outbox_.sent() < send_window_; message = outbox_.next()) {
    if (is_too_large(message->topic, message->payload)) {
      ++statistics_.too_large;
      outbox_.drop_next();
      continue;
    }
    int packet_id = 0;
    const int error = mosquitto_publish_v5(client_.get(),
                                           &packet_id,
                                           message->topic.c_str(),
                                           size_of(message->payload),
                                           message->payload.data(),
                                           kAtLeastOnce,
                                           message->retain,
                                           nullptr);
    if (error == MOSQ_ERR_INVAL || error == MOSQ_ERR_MALFORMED_UTF8) {
      ++statistics_.refused;
      last_refused_ = RefusedMessage{message->topic, Reason::kProtocolError};
      outbox_.drop_next();
      continue;
    }
    if (error != MOSQ_ERR_SUCCESS) {
      return;
    }
    ++statistics_.published;
    statistics_.published_bytes += message->topic.size() + message->payload.size();
    outbox_.note_sent(packet_id);
  }
}

bool Connection::is_too_large(std::string_view topic, std::string_view payload) const {
  return max_packet_bytes_ &&
         publish_packet_bytes(topic.size(), payload.size()) > *max_packet_bytes_;
}

bool Connection::has_bytes() const {
  pollfd socket{mosquitto_socket(client_.get()), POLLIN, 0};
  return socket.fd >= 0 && ::poll(&socket, 1, 0) > 0;
}

void Connection::end(Clock::time_point now, Reason reason) {
  statistics_.failed_attempts += is_connected_ ? 0 : 1;
  is_connected_ = false;
  reason_ = reason;
  was_taken_over_ = was_taken_over_ || reason == Reason::kTakenOver;
  client_.reset();
  outbox_.reset_sent();
  backoff_.note_failed(now);
}

Reason Connection::reason_of_error(int error) const {
  if (reported_reason_ != Reason::kNone) {
    return reported_reason_;
  }
  switch (error) {
    case MOSQ_ERR_EAI:
      return Reason::kUnknownHost;
    case MOSQ_ERR_TLS:
      return Reason::kTlsFailed;
    case MOSQ_ERR_KEEPALIVE:
      return Reason::kSilent;
    default:
      break;
  }
  if (is_connected_) {
    return Reason::kLost;
  }
  return error == MOSQ_ERR_ERRNO && errno != ECONNRESET ? Reason::kUnreachable
                                                        : Reason::kClosedUnanswered;
}

}  // namespace echomap::mqtt
