// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "host/fleet_messages/messages.hpp"
#include "host/fleet_messages/refused_reason.hpp"

namespace echomap::fleet_messages {

/// Version of the schema, a payload's first byte. A receiver refuses every other one.
inline constexpr std::uint8_t kSchemaVersion = 1;
/// Largest size of a payload, bytes,
inline constexpr std::size_t kMaxPayloadBytes = 16384;
/// and of an uncompressed body.
inline constexpr std::size_t kMaxBodyBytes = 65536;

/// Author of a message, and the message's place in the author's sequence.
struct Sender {
  std::string robot;          ///< A valid name.
  std::uint32_t boot_id = 0;  ///< Larger after each start of the robot's host. Objects have none.
  std::uint32_t counter = 0;  ///< Larger with each message since. Objects have none.
  bool operator==(const Sender&) const = default;
};

/// A message with its author.
struct FleetMessage {
  Sender sender;
  MessageBody body;
  bool operator==(const FleetMessage&) const = default;
};

/// Encodes a message; empty where a receiver would refuse it, for example as too large.
std::optional<std::string> encode(const FleetMessage& message);

/// Decodes a message, or returns why the bytes are not one.
std::variant<FleetMessage, RefusedReason> decode(std::string_view payload);

/// A decoded message with its topic, both of which fit each other.
struct TopicMessage {
  FleetTopic topic;
  FleetMessage message;
};

/// Decodes a payload and compares it with its topic: the kind, the page or map number, an object's
/// hash, and the author, who differs from the topic's robot on relay topics only.
std::variant<TopicMessage, RefusedReason> decode(std::string_view topic, std::string_view payload);

/// Topic that a message is published on. `payload` is the encoded message, whose hash is the name
/// of an object.
FleetTopic topic_of(const std::string& fleet,
                    const FleetMessage& message,
                    std::string_view payload);

/// Kind of a message.
TopicKind kind_of(const MessageBody& body);

/// Number of the author's map that a message belongs to; empty where it belongs to none.
std::optional<std::uint16_t> map_number_of(const MessageBody& body);

}  // namespace echomap::fleet_messages
