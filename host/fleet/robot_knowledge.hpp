// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "host/fleet/fleet_state.hpp"
#include "host/fleet_messages/messages.hpp"

namespace echomap::fleet {

/// Largest number of objects and maps of one robot, a week of stops. Without a limit, a robot that
/// repeats itself would exhaust the memory of all.
inline constexpr std::size_t kMaxObjectsOfARobot = 20'000;
inline constexpr std::size_t kMaxMapsOfARobot = 256;

/// What one robot has published, received from itself, the broker or a relay.
class RobotKnowledge {
 public:
  explicit RobotKnowledge(std::string name) : name_(std::move(name)) {}

  const std::string& name() const { return name_; }

  /// Stores a message that is newer than all of its kind before; `now_s` is of the caller's clock.
  /// Objects are identified by their hash and come once each. True where records, batches or the
  /// alignment change.
  bool take(const fleet_messages::MessageBody& body,
            const fleet_messages::ContentHash& hash,
            double now_s);

  /// Records the boot id of a message. A new one voids the search report of the start before.
  void note_boot(std::uint32_t boot_id) {
    if (boot_id > boot_id_) {
      boot_id_ = boot_id;
      search_.reset();
    }
  }
  /// Whether the limits above allow another such message.
  bool has_room_for(const fleet_messages::MessageBody& body) const;
  /// Records that a message of the robot itself was received.
  void set_last_seen(double now_s) {
    last_seen_s_ = now_s;
    has_reported_ = true;
    is_lost_ = false;
  }
  /// Records that a retained message of the robot was received. Its age counts from then on, where
  /// the robot was not seen before.
  void set_first_seen(double now_s) { last_seen_s_ = last_seen_s_.value_or(now_s); }
  /// Records the robot's last will.
  void lose() { is_lost_ = true; }

  Attendance attendance(double now_s, double gone_after_s) const;
  double age_s(double now_s) const;
  const std::optional<fleet_messages::PresenceMessage>& presence() const { return presence_; }
  /// Objects that the robot has announced, as far as the pages of its manifest were received.
  std::vector<fleet_messages::ContentHash> promised() const;
  bool has_promised(const fleet_messages::ContentHash& hash) const;

  FleetRobot state(double now_s, double gone_after_s) const;

 private:
  /// An object's hash and its content.
  template <class T>
  using Named = std::pair<fleet_messages::ContentHash, T>;

  struct Map {
    std::map<std::uint32_t, Named<team_map::Submap>> submaps;
    std::map<fleet_messages::ContentHash, fleet_messages::SourceBatch> batches;
    fleet_messages::GraphMessage graph;
    /// Cached for the state; null where it has to be rebuilt.
    mutable std::shared_ptr<const team_map::RobotRecord> record;
    mutable std::shared_ptr<const std::vector<fleet_messages::SourceBatch>> shown_batches;
  };

  bool add(const fleet_messages::SubmapMessage& message, const fleet_messages::ContentHash& hash);
  bool add(const fleet_messages::SourceMessage& message, const fleet_messages::ContentHash& hash);
  bool set_graph(const fleet_messages::GraphMessage& message);
  bool set_alignment(const fleet_messages::AlignmentMessage& message);
  bool set_presence(const fleet_messages::PresenceMessage& message);
  void set_pose(const fleet_messages::PoseMessage& message, double now_s);
  void set_claims(const fleet_messages::ClaimMessage& message);
  void set_search(const fleet_messages::SearchMessage& message);
  FleetMap shown(std::uint16_t number, const Map& map) const;

  std::string name_;
  std::size_t objects_ = 0;  ///< Including those that another one of their index replaces.
  std::optional<double> last_seen_s_;
  std::optional<FleetPose> pose_;
  double posed_s_ = 0.0;
  std::map<std::uint16_t, Map> maps_;
  std::map<std::uint16_t, std::vector<fleet_messages::ContentHash>> pages_;
  std::vector<team_exploration::Claim> claims_;
  std::optional<fleet_messages::SearchReport> search_;
  std::vector<fleet_messages::AlignedMap> alignment_;
  std::optional<fleet_messages::PresenceMessage> presence_;
  std::uint32_t boot_id_ = 0;
  std::uint16_t claims_map_number_ = 0;
  std::uint16_t search_map_number_ = 0;
  bool has_reported_ = false;
  bool is_lost_ = false;
};

}  // namespace echomap::fleet
