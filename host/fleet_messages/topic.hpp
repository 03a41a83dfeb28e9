// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "host/fleet_messages/content_hash.hpp"

namespace echomap::fleet_messages {

/// Kind of the messages on a topic.
enum class TopicKind : std::uint8_t {
  kPresence,
  kPose,
  kSubmap,
  kGraph,
  kManifest,
  kClaim,
  kSource,
  kClock,
  kAlignment,
  kAsk,
  kSearch,
  kRelay,
};

/// All kinds, in the order of the enumerators.
inline constexpr TopicKind kTopicKinds[] = {TopicKind::kPresence,
                                            TopicKind::kPose,
                                            TopicKind::kSubmap,
                                            TopicKind::kGraph,
                                            TopicKind::kManifest,
                                            TopicKind::kClaim,
                                            TopicKind::kSource,
                                            TopicKind::kClock,
                                            TopicKind::kAlignment,
                                            TopicKind::kAsk,
                                            TopicKind::kSearch,
                                            TopicKind::kRelay};

/// Last level of a topic: nothing, a page or map number, or the name of an object.
using TopicId = std::variant<std::monostate, std::uint16_t, ContentHash>;

/// A topic of a fleet: `echomap/1/FLEET/ROBOT/KIND` or `echomap/1/FLEET/ROBOT/KIND/ID`. A robot
/// writes below its own name only.
struct FleetTopic {
  std::string fleet;
  std::string robot;
  TopicKind kind = TopicKind::kPresence;
  TopicId id;
  bool operator==(const FleetTopic&) const = default;
};

/// Name of a kind in a topic: "presence", "pose" ..
std::string_view name_of(TopicKind kind);

/// Whether the broker retains the latest message of such a topic for late joiners.
bool is_retained(TopicKind kind);

/// Text of a topic. Fleet and robot must have valid names, and the id must be of the kind's type.
std::string format_topic(const FleetTopic& topic);

/// Parses what `format_topic` returns; empty for any other text.
std::optional<FleetTopic> parse_topic(std::string_view text);

/// MQTT filter for all topics of a fleet.
std::string fleet_filter(std::string_view fleet);

}  // namespace echomap::fleet_messages
