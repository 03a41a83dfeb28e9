// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace echomap::mqtt {

/// MQTT's quality of service; a message that is sent at least once may come twice.
enum class Delivery : std::uint8_t { kAtMostOnce, kAtLeastOnce };

/// A message that was received on a topic.
struct Message {
  std::string topic;
  std::string payload;       ///< Any bytes.
  bool is_retained = false;  ///< The broker had retained it; it is not new.
};

/// Publishes and receives messages. No call blocks.
class MessageBus {
 public:
  virtual ~MessageBus() = default;

  /// Publishes a message. Without a connection, one at least once is stored until there is one, and
  /// one at most once is dropped. False where it is larger than the broker accepts, which would end
  /// the connection: then nothing is sent.
  virtual bool publish(const std::string& topic,
                       std::string_view payload,
                       Delivery delivery,
                       bool retain) = 0;
  /// Subscribes to a filter, now and after every reconnection: first come retained messages. What
  /// this client publishes comes, too.
  virtual void subscribe(const std::string& filter) = 0;
  /// Serves the connection, and returns the messages received since the last call, in their order.
  virtual std::vector<Message> take() = 0;
  virtual bool is_connected() const = 0;
  /// Number of connections so far. After each, a publisher has to compare what the broker has
  /// retained.
  virtual std::size_t connections() const = 0;
};

}  // namespace echomap::mqtt
