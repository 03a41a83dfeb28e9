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

/// Whether the hash `latest_set` of presence messages covers the latest message of this kind.
constexpr bool is_in_latest_set(fleet_messages::TopicKind kind) {
  using fleet_messages::TopicKind;
  return kind == TopicKind::kGraph || kind == TopicKind::kClaim || kind == TopicKind::kAlignment ||
         kind == TopicKind::kSearch;
}

/// Whether other robots relay messages of this kind for a robot that is gone.
constexpr bool is_passed_on(fleet_messages::TopicKind kind) {
  using fleet_messages::TopicKind;
  return kind == TopicKind::kPresence || kind == TopicKind::kManifest ||
         kind == TopicKind::kGraph || fleet_messages::is_object(kind);
}

/// Largest number of robots in a fleet. A site has up to 50; a faulty robot could invent more.
inline constexpr std::size_t kMaxRobots = 256;

/// A request for missing data, and the robot that sent it.
struct ReceivedRequest {
  std::string from;
  fleet_messages::AskMessage request;
};

/// A message of another robot, as it was received.
struct StoredPayload {
  fleet_messages::TopicKind kind = fleet_messages::TopicKind::kPresence;
  std::uint32_t boot_id = 0;  ///< Boot id of its author; 0 for an object.
  std::string payload;
  double last_received_s = 0.0;  ///< When it was received last, from any robot.
};

/// A message that the robot itself published before its start and that the broker has retained.
struct FoundPayload {
  fleet_messages::TopicMessage decoded;
  std::string payload;
};

/// Collects the messages of a fleet: validates them, sorts them by author, and stores what is
/// needed to relay them.
class FleetKnowledge {
 public:
  /// `robot` is the robot that collects; empty for an observer. Another robot is gone after
  /// `gone_after_s` seconds without a message.
  FleetKnowledge(std::string fleet, std::string robot, double gone_after_s);

  /// Processes a message from the bus, of another robot or of this one.
  void take(const mqtt::Message& message, double now_s);
  /// Records what this robot itself publishes, before the broker sends it back.
  void take_own(const fleet_messages::MessageBody& body,
                const fleet_messages::ContentHash& hash,
                double now_s);

  /// Requests of other robots since the last call.
  std::vector<ReceivedRequest> take_requests();
  /// Objects and graphs of this robot that the broker had retained and this host did not know,
  /// since the last call.
  std::vector<FoundPayload> take_found_own();

  /// Largest boot id of this robot's messages that the broker had retained; 0 for none.
  std::uint32_t retained_boot_id() const { return retained_boot_id_; }

  FleetState state(double now_s) const;
  const std::map<std::string, RobotKnowledge>& robots() const { return robots_; }
  bool is_alive(const std::string& robot, double now_s) const;
  bool has(const fleet_messages::ContentHash& object) const { return objects_.contains(object); }
  std::size_t object_count() const { return objects_.size(); }
  fleet_messages::ContentHash object_set() const;
  /// Number of objects that robots have announced and that were not received.
  std::size_t missing_objects() const;
  /// Whether the robot's last presence announced graphs, claims or an alignment that were not
  /// received.
  bool is_behind(const std::string& robot) const { return behind_.contains(robot); }
  /// Latest messages of a robot except poses, by topic.
  const std::map<std::string, StoredPayload>& stored(const std::string& robot) const;
  std::uint64_t revision() const { return revision_; }
  const ReceptionStatistics& statistics() const { return statistics_; }

 private:
  RobotKnowledge& knowledge_of(const std::string& robot);
  void take_foreign(const fleet_messages::TopicMessage& decoded,
                    const mqtt::Message& message,
                    double now_s);
  /// Processes a message that is new.
  void take_new(const fleet_messages::FleetMessage& message,
                const fleet_messages::ContentHash& hash,
                double now_s);
  void compare_latest(const fleet_messages::Sender& sender,
                      const fleet_messages::PresenceMessage& presence);
  void take_found(const fleet_messages::TopicMessage& decoded, const mqtt::Message& message);
  /// Whether the message is new, last wills included.
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
  ReplayGuard guard_;         ///< Of messages from their authors,
  ReplayGuard relays_guard_;  ///< and of relayed ones, which never override those.
  std::map<std::string, RobotKnowledge> robots_;
  std::map<std::string, std::map<std::string, StoredPayload>> stored_;
  std::set<std::string> behind_;
  std::set<fleet_messages::ContentHash> objects_;
  mutable std::optional<fleet_messages::ContentHash> object_set_;  ///< Empty: has to be computed.
  std::vector<ReceivedRequest> requests_;
  std::vector<FoundPayload> found_own_;
  std::uint32_t retained_boot_id_ = 0;
  std::uint64_t revision_ = 0;
  ReceptionStatistics statistics_;
};

}  // namespace echomap::fleet
