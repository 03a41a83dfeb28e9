// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "host/fleet/exchange_statistics.hpp"
#include "host/fleet/replay_guard.hpp"
#include "host/fleet/robot_knowledge.hpp"
#include "host/fleet_messages/payload.hpp"
#include "host/mqtt/message_bus.hpp"

namespace echomap::fleet {

/// Whether presence messages have the hash of the latest message of such a topic.
constexpr bool is_in_latest_set(fleet_messages::TopicKind kind) {
  using fleet_messages::TopicKind;
  return kind == TopicKind::kGraph || kind == TopicKind::kClaim || kind == TopicKind::kAlignment ||
         kind == TopicKind::kSearch;
}

/// Whether others pass such a message on of a robot that is gone.
constexpr bool is_passed_on(fleet_messages::TopicKind kind) {
  using fleet_messages::TopicKind;
  return kind == TopicKind::kPresence || kind == TopicKind::kManifest ||
         kind == TopicKind::kGraph || fleet_messages::is_object(kind);
}

/// Robots that a fleet may have: a site has up to 50, and one of them may invent others.
inline constexpr std::size_t kMaxRobots = 256;

/// What a robot asks for.
struct HeardAsk {
  std::string from;
  fleet_messages::AskMessage ask;
};

/// A message of another robot, as it came.
struct StoredPayload {
  fleet_messages::TopicKind kind = fleet_messages::TopicKind::kPresence;
  std::uint32_t boot_id = 0;  ///< Of its author; 0 of an object.
  std::string payload;
  double heard_s = 0.0;  ///< When it was heard last, from anybody.
};

/// A message of the robot itself that the broker has kept from before its start.
struct FoundPayload {
  fleet_messages::TopicMessage decoded;
  std::string payload;
};

/// Takes in what a fleet says: checks it, sorts it by author, and remembers what it would take to
/// pass it on.
class FleetKnowledge {
 public:
  /// Of that robot. `gone_after_s`: without a message, seconds.
  FleetKnowledge(std::string fleet, std::string robot, double gone_after_s);

  /// Takes in a message of the bus, of others or of the robot itself.
  void take(const mqtt::Message& message, double now_s);
  /// Takes in what the robot itself says, at once.
  void take_own(const fleet_messages::MessageBody& body,
                const fleet_messages::ContentHash& hash,
                double now_s);

  /// Questions since the last call, of others.
  std::vector<HeardAsk> take_asks();
  /// Objects and graphs of this robot since the last call that it did not know of.
  std::vector<FoundPayload> take_found_own();

  /// The largest boot id of what the broker had kept of this robot; 0 for nothing.
  std::uint32_t kept_boot_id() const { return kept_boot_id_; }

  FleetState state(double now_s) const;
  const std::map<std::string, RobotKnowledge>& robots() const { return robots_; }
  bool is_alive(const std::string& robot, double now_s) const;
  bool has(const fleet_messages::ContentHash& object) const { return objects_.contains(object); }
  std::size_t object_count() const { return objects_.size(); }
  fleet_messages::ContentHash object_set() const;
  /// How many objects the robots said they have made that have not come.
  std::size_t missing_objects() const;
  /// Whether the robot, when it was heard last, had graphs, claims or an alignment that have not
  /// come.
  bool is_behind(const std::string& robot) const { return behind_.contains(robot); }
  /// The latest messages of a robot but for poses, by topic.
  const std::map<std::string, StoredPayload>& stored(const std::string& robot) const;
  std::uint64_t revision() const { return revision_; }
  const ReceptionStatistics& statistics() const { return statistics_; }

 private:
  RobotKnowledge& knowledge_of(const std::string& robot);
  void take_foreign(const fleet_messages::TopicMessage& decoded,
                    const mqtt::Message& message,
                    double now_s);
  /// Takes in a message that is new.
  void take_new(const fleet_messages::FleetMessage& message,
                const fleet_messages::ContentHash& hash,
                double now_s);
  void compare_latest(const fleet_messages::Sender& sender,
                      const fleet_messages::PresenceMessage& presence);
  void take_found(const fleet_messages::TopicMessage& decoded, const mqtt::Message& message);
  /// Whether the message is new, and a last will taken care of.
  bool is_new(const fleet_messages::TopicMessage& decoded,
              const std::string& topic,
              bool is_of_the_past);
  bool accepts_relay(const fleet_messages::FleetMessage& message,
                     const fleet_messages::ContentHash& hash,
                     double now_s) const;
  bool has_room_for(const fleet_messages::FleetMessage& message) const;
  void refuse(fleet_messages::RefusedReason reason);

  std::string fleet_;
  std::string robot_;
  double gone_after_s_;
  ReplayGuard guard_;         ///< Of what authors have sent themselves,
  ReplayGuard relays_guard_;  ///< and of what others say that they have: it never overrules that.
  std::map<std::string, RobotKnowledge> robots_;
  std::map<std::string, std::map<std::string, StoredPayload>> stored_;
  std::set<std::string> behind_;
  std::set<fleet_messages::ContentHash> objects_;
  mutable std::optional<fleet_messages::ContentHash> object_set_;  ///< Empty: to be computed.
  std::vector<HeardAsk> asks_;
  std::vector<FoundPayload> found_own_;
  std::uint32_t kept_boot_id_ = 0;
  std::uint64_t revision_ = 0;
  ReceptionStatistics statistics_;
};

}  // namespace echomap::fleet
