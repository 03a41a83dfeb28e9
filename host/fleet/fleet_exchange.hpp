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

/// The will that a robot's connection is made with: presence as gone.
mqtt::LastWill last_will(const FleetExchangeParams& params);

/// One robot's part in what its fleet exchanges over a bus: it says what the robot has made and
/// where it is, hears the others, and sees to it that everybody ends with the same, whatever the
/// broker and the network lose (docs/fleet_protocol.md). One thread; no call waits but for the
/// disk, where there is a folder.
class FleetExchange {
 public:
  /// Reads the folder, where there is one, and begins a new map behind those in it. The bus
  /// outlives the exchange. Throws std::invalid_argument for invalid parameters and
  /// files::FileError where the folder cannot be read.
  FleetExchange(mqtt::MessageBus& bus, const FleetExchangeParams& params);
  FleetExchange(const FleetExchange&) = delete;
  FleetExchange& operator=(const FleetExchange&) = delete;

  /// The map that the robot is making: submaps, graph, pose and claims are of this one.
  std::uint16_t map_number() const { return map_number_; }
  /// The robot was carried away, say: what follows is of another map, with submaps from 0 on.
  void begin_map();

  /// Publishes a submap, an object. The robot uses the one that is returned, as all others do; it
  /// is empty, and nothing is published, where the submap does not fit into a message.
  std::optional<team_map::Submap> add_submap(const team_map::Submap& submap);
  /// The same for readings of a scalar sensor.
  std::optional<fleet_messages::SourceBatch> add_source_batch(
      const fleet_messages::SourceBatch& batch);
  /// Publishes the robot's pose graph, and the covariance of its last pose. False where it does not
  /// fit into a message; this holds for what follows, too.
  bool set_graph(const std::vector<geometry::Pose2>& T_map_submaps,
                 const Eigen::Matrix3d& latest_covariance);
  bool set_claims(const std::vector<team_exploration::Claim>& claims);
  /// Of a robot that searches a source: what it has come to and is about to read.
  bool set_search(const fleet_messages::SearchReport& report);
  bool set_alignment(const std::vector<fleet_messages::AlignedMap>& maps);
  /// Publishes where the robot is, at most as often as the parameters say. `stamp_s` is of the
  /// robot's clock.
  bool set_pose(const fleet_messages::PoseEstimate& pose, double stamp_s);
  /// Says good-bye: claims are given back, what it has made stays. The next update() sends it.
  void leave();

  /// Takes in what has come and sends what is due. `now_s` is of any clock that does not go back;
  /// in lockstep that of simulated time.
  void update(double now_s);

  /// What the robot knows of its fleet now, and of itself. Cheap but for what has changed.
  FleetState state() const { return knowledge_.state(now_s_); }
  /// FleetState::revision, without making the state.
  std::uint64_t revision() const { return knowledge_.revision(); }
  /// Messages of which this robot is the source and that the broker has not sent back: 0 when all
  /// that it has made is out.
  std::size_t unconfirmed() const { return publications_.unconfirmed(); }
  ExchangeStatistics statistics() const;

 private:
  /// A pose as it is sent.
  struct SentPose {
    geometry::Pose2 T_map_robot;
    double at_s = 0.0;
  };

  void load();
  void take_in();
  void begin_later_boot(std::uint32_t boot_id);
  /// Becomes the source of a message of its own from before its start. False where it is already.
  bool adopt(const fleet_messages::FleetTopic& topic,
             const fleet_messages::FleetMessage& message,
             const std::string& payload);
  void answer(const HeardAsk& heard);
  void look_around();
  void send_presence(fleet_messages::PresenceState state);
  void send_pose();
  bool publish(const fleet_messages::MessageBody& body, Worth worth);
  bool add_object(const fleet_messages::MessageBody& body);
  /// Writes an object on the last page of the manifest.
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
  bool has_own_submap_ = false;  ///< Of this map.
  std::uint32_t counter_ = 0;
  std::optional<fleet_messages::PoseMessage> pose_;
  std::optional<SentPose> sent_pose_;
  std::size_t connections_ = 0;
  double now_s_ = 0.0;
  std::optional<double> presence_sent_s_;
  std::optional<double> looked_s_;
  bool has_left_ = false;
  std::size_t asks_ = 0;
  std::size_t unsaved_ = 0;
};

}  // namespace echomap::fleet
