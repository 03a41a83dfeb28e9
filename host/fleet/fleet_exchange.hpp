// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host/fleet/exchange_params.hpp"
#include "host/fleet/exchange_statistics.hpp"
#include "host/fleet/fleet_knowledge.hpp"
#include "host/fleet/fleet_state.hpp"
#include "host/fleet/missing_watch.hpp"
#include "host/fleet/own_folder.hpp"
#include "host/fleet/publications.hpp"
#include "host/fleet/relays.hpp"
#include "host/mqtt/last_will.hpp"
#include "host/mqtt/message_bus.hpp"

namespace echomap::fleet {

/// Last will for a robot's MQTT connection: its presence with the state gone.
mqtt::LastWill last_will(const FleetExchangeParams& params);

/// Exchanges the data of one robot with its fleet over a message bus. It publishes what the robot
/// has made and where it is, receives what the others publish, and brings all members to the same
/// data, whatever the broker and the network lose (docs/fleet_protocol.md). Single-threaded; no
/// call blocks, except on the disk where there is a folder.
class FleetExchange {
 public:
  /// Reads the folder, where there is one, and begins a new map with the next free number. `bus`
  /// must outlive this. Throws std::invalid_argument for invalid parameters and files::FileError
  /// where the folder cannot be read.
  FleetExchange(mqtt::MessageBus& bus, const FleetExchangeParams& params);
  FleetExchange(const FleetExchange&) = delete;
  FleetExchange& operator=(const FleetExchange&) = delete;

  /// Number of the map that the robot is building. Its submaps, graph, pose and claims belong to
  /// it.
  std::uint16_t map_number() const { return map_number_; }
  /// Begins another map, for example after the robot was carried away. Its submaps count from 0.
  void begin_map();

  /// Publishes a submap as an object. Returns the submap as all receivers have it, which the robot
  /// has to use as well. Empty, with nothing published, where the submap does not fit into a
  /// message.
  std::optional<team_map::Submap> add_submap(const team_map::Submap& submap);
  /// Publishes readings of a scalar sensor as an object, and returns them as `add_submap` does.
  std::optional<fleet_messages::SourceBatch> add_source_batch(
      const fleet_messages::SourceBatch& batch);
  /// Publishes the robot's pose graph and the covariance of its last pose. Returns false where they
  /// do not fit into a message, as the functions below do.
  bool set_graph(const std::vector<geometry::Pose2>& T_map_submaps,
                 const Eigen::Matrix3d& latest_covariance);
  bool set_claims(const std::vector<team_exploration::Claim>& claims);
  /// Publishes what a robot that searches a source has found and is about to read.
  bool set_search(const fleet_messages::SearchReport& report);
  bool set_alignment(const std::vector<fleet_messages::AlignedMap>& maps);
  /// Publishes the robot's pose, at most as often as the parameters allow. `stamp_s` is on the
  /// robot's clock.
  bool set_pose(const fleet_messages::PoseEstimate& pose, double stamp_s);
  /// Leaves the fleet: gives the claims back and announces it with the next update(). Published
  /// objects stay.
  void leave();

  /// Processes received messages and sends what is due. `now_s` is of any clock that never runs
  /// backwards, in lockstep of simulated time.
  void update(double now_s);

  /// What the robot knows of its fleet and of itself. Cheap except for what has changed.
  FleetState state() const { return knowledge_.state(now_s_); }
  /// FleetState::revision, without building the state.
  std::uint64_t revision() const { return knowledge_.revision(); }
  /// Number of this robot's retained messages that the broker has not sent back yet: 0 once all
  /// that it has made is out.
  std::size_t unconfirmed() const { return publications_.unconfirmed(); }
  ExchangeStatistics statistics() const;

 private:
  /// The pose that was published last, and when.
  struct SentPose {
    geometry::Pose2 T_map_robot;
    double at_s = 0.0;
  };

  void load();
  void take_in();
  void begin_later_boot(std::uint32_t boot_id);
  /// Takes over a message that this robot published before its start. False where it has done so
  /// already.
  bool adopt(const fleet_messages::FleetTopic& topic,
             const fleet_messages::FleetMessage& message,
             const std::string& payload);
  void answer(const ReceivedRequest& received);
  void look_around();
  void send_presence(fleet_messages::PresenceState state);
  void send_pose();
  bool publish(const fleet_messages::MessageBody& body, Worth worth);
  bool add_object(const fleet_messages::MessageBody& body);
  /// Adds an object to the last page of the manifest, and publishes the page.
  void list_object(const fleet_messages::ContentHash& hash);
  void save(const fleet_messages::MessageBody& body, const std::string& payload);
  std::optional<std::string> encode(const fleet_messages::MessageBody& body);

  mqtt::MessageBus& bus_;
  FleetExchangeParams params_;
  OwnFolder folder_;
  FleetKnowledge knowledge_;
  Publications publications_;
  Relays relays_;
  MissingWatch missing_;
  std::vector<fleet_messages::ContentHash> own_objects_;  ///< In the manifest's order.
  std::uint32_t listed_objects_ = 0;                      ///< On the pages that were sent.
  std::uint16_t map_number_ = 0;
  bool has_own_submap_ = false;  ///< Whether the robot has published a submap of this map.
  std::uint32_t counter_ = 0;
  std::optional<fleet_messages::PoseMessage> pose_;
  std::optional<SentPose> sent_pose_;
  std::size_t connections_ = 0;
  double now_s_ = 0.0;
  std::optional<double> presence_sent_s_;
  std::optional<double> looked_s_;
  bool has_left_ = false;
  std::size_t requests_ = 0;
  std::size_t unsaved_ = 0;
};

}  // namespace echomap::fleet
