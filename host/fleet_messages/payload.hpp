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
/// The most bytes of a payload,
inline constexpr std::size_t kMaxPayloadBytes = 16384;
/// and of a body that was unpacked.
inline constexpr std::size_t kMaxBodyBytes = 65536;

/// Who sent a message, and when.
struct Sender {
  std::string robot;          ///< A valid name.
  std::uint32_t boot_id = 0;  ///< Larger after each start of the robot's host. Objects have none.
  std::uint32_t counter = 0;  ///< Larger with each message since. Objects have none.
  bool operator==(const Sender&) const = default;
};

/// A whole message.
struct FleetMessage {
  Sender sender;
  MessageBody body;
  bool operator==(const FleetMessage&) const = default;
};

/// The message as bytes; empty where a receiver would refuse it, as one that is too large.
std::optional<std::string> encode(const FleetMessage& message);

/// The message that bytes are, or why they are none.
std::variant<FleetMessage, RefusedReason> decode(std::string_view payload);

/// What came on a topic, and whether topic and payload fit each other.
struct TopicMessage {
  FleetTopic topic;
  FleetMessage message;
};

/// Decodes a payload and compares it with its topic: the kind, the page or map number, an object's
/// hash, and the author, who is someone else on a relay's topic only.
std::variant<TopicMessage, RefusedReason> decode(std::string_view topic, std::string_view payload);

/// The topic that a message is published on. `payload` are its bytes, of whose hash objects have
/// their name.
FleetTopic topic_of(const std::string& fleet,
                    const FleetMessage& message,
                    std::string_view payload);

/// The kind of a message.
TopicKind kind_of(const MessageBody& body);

/// Of which map of its author a message is; empty where it is of none.
std::optional<std::uint16_t> map_number_of(const MessageBody& body);

}  // namespace echomap::fleet_messages
