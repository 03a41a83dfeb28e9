// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace echomap::mqtt {

/// MQTT's quality of service; what is sent at least once may come twice.
enum class Delivery : std::uint8_t { kAtMostOnce, kAtLeastOnce };

/// What came on a topic.
struct Message {
  std::string topic;
  std::string payload;       ///< Any bytes.
  bool is_retained = false;  ///< It was kept by the broker, and is not of this moment.
};

/// Where messages are published and heard. No call waits.
class MessageBus {
 public:
  virtual ~MessageBus() = default;

  /// Hands a message over. Without a connection, one at least once is kept until there is one, and
  /// one at most once is dropped. False where it is larger than the broker takes, which would end
  /// the connection: then nothing is sent.
  virtual bool publish(const std::string& topic,
                       std::string_view payload,
                       Delivery delivery,
                       bool retain) = 0;
  /// Hears what matches the filter from now on, and after every reconnection again: first what is
  /// retained, and what this client publishes, too.
  virtual void subscribe(const std::string& filter) = 0;
  /// Serves the connection, and answers what has come since the last call, in its order.
  virtual std::vector<Message> take() = 0;
  virtual bool is_connected() const = 0;
  /// How often it was connected so far: whoever is the source of something compares what the broker
  /// has after each.
  virtual std::size_t connections() const = 0;
};

}  // namespace echomap::mqtt
