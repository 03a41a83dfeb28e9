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

/// What a robot may make at most. It is a week of stops; without a bound one that repeats itself
/// would take the memory of all.
inline constexpr std::size_t kMaxObjectsOfARobot = 20'000;
inline constexpr std::size_t kMaxMapsOfARobot = 256;

/// What one robot has told, whoever passed it on.
class RobotKnowledge {
 public:
  explicit RobotKnowledge(std::string name) : name_(std::move(name)) {}

  const std::string& name() const { return name_; }

  /// Takes in what is newer than all of its kind before; `now_s` is of the caller's clock. Objects
  /// go by their hash and come once each. True where records, batches or alignment change.
  bool take(const fleet_messages::MessageBody& body,
            const fleet_messages::ContentHash& hash,
            double now_s);

  /// Something of that start of its host has come: what it said of a search before was of another.
  void note_boot(std::uint32_t boot_id) {
    if (boot_id > boot_id_) {
      boot_id_ = boot_id;
      search_.reset();
    }
  }
  /// Whether that is within what a robot may make.
  bool has_room_for(const fleet_messages::MessageBody& body) const;
  /// The robot itself has been heard.
  void hear(double now_s) {
    heard_s_ = now_s;
    is_heard_ = true;
    is_lost_ = false;
  }
  /// The broker or somebody else has kept something of it: it counts from then on, where it was not
  /// heard at all.
  void hear_of(double now_s) { heard_s_ = heard_s_.value_or(now_s); }
  /// The broker has lost it.
  void lose() { is_lost_ = true; }

  Attendance attendance(double now_s, double gone_after_s) const;
  double age_s(double now_s) const;
  const std::optional<fleet_messages::PresenceMessage>& presence() const { return presence_; }
  /// The objects that it said it has made, as far as the pages of its manifest have come.
  std::vector<fleet_messages::ContentHash> promised() const;
  bool has_promised(const fleet_messages::ContentHash& hash) const;

  FleetRobot state(double now_s, double gone_after_s) const;

 private:
  /// An object's hash and what it holds.
  template <class T>
  using Named = std::pair<fleet_messages::ContentHash, T>;

  struct Map {
    std::map<std::uint32_t, Named<team_map::Submap>> submaps;
    std::map<fleet_messages::ContentHash, fleet_messages::SourceBatch> batches;
    fleet_messages::GraphMessage graph;
    /// What the state shows; null where it is to be made anew.
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
  std::size_t objects_ = 0;  ///< With those of which another one is used.
  std::optional<double> heard_s_;
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
  bool is_heard_ = false;
  bool is_lost_ = false;
};

}  // namespace echomap::fleet
