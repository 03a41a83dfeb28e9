// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "host/fleet_messages/content_hash.hpp"

namespace echomap::fleet_messages {

/// What a topic is for.
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

/// All of them, in the order of the enumerators.
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

/// What follows the kind: nothing, a page or map number, or the name of an object.
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

/// As it is written in a topic: "presence", "pose" ..
std::string_view name_of(TopicKind kind);

/// Whether broker and late joiners are to have the latest message of such a topic.
bool is_retained(TopicKind kind);

/// The topic's text. Fleet and robot have valid names, and the kind has an id of its type.
std::string format_topic(const FleetTopic& topic);

/// The topic of a text; empty where it is none that `format_topic` writes.
std::optional<FleetTopic> parse_topic(std::string_view text);

/// The filter of all topics of a fleet.
std::string fleet_filter(std::string_view fleet);

}  // namespace echomap::fleet_messages
