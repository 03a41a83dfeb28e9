// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "host/fleet/fleet_exchange.hpp"
#include "host/fleet_member/join_log.hpp"
#include "host/fleet_member/search_board.hpp"
#include "host/fleet_member/source_recorder.hpp"
#include "host/fleet_member/team_picture.hpp"
#include "host/pipeline/observation_fork.hpp"
#include "host/pipeline/snapshot.hpp"
#include "host/session/robot_context.hpp"
#include "host/team_exploration/peer_echo_filter.hpp"
#include "host/team_exploration/team_board.hpp"
#include "host/team_exploration/unplaced_peers.hpp"
#include "host/team_map/submap_recorder.hpp"

namespace echomap::fleet_member {

/// Parameters of a robot as a member of its fleet. Values are ours.
struct FleetMemberParams {
  fleet::FleetExchangeParams exchange;
  team_map::TeamMapParams team;
  team_exploration::PeerEchoParams echoes;
  team_exploration::UnplacedPeerParams unplaced;
  /// Messages are exchanged at whole multiples of this, seconds of the session's time.
  double exchange_period_s = 0.1;
  /// Growth of the position error of a peer that drives, for each second since its last pose,
  double peer_drift_m_per_s = 0.1;
  /// up to this many: a peer that publishes none for longer stands still.
  double peer_drift_s = 2.0;
  /// For a robot that searches a source: how its readings are placed, and the length of a batch,
  /// seconds.
  std::optional<source_search::SourceReadingsParams> source;
  double source_batch_s = 4.0;
};

/// A connected robot as a member of a fleet: publishes each stop, its pose and its claim, and has
/// what the others have published in its own map frame. Echoes of the others and contacts with them
/// are kept out of its map.
class FleetMember final : public SearchBoard {
 public:
  /// `robot` has begun its maps and is not open yet; it and the bus must outlive this. Throws as
  /// FleetExchange.
  FleetMember(session::RobotContext& robot, mqtt::MessageBus& bus, const FleetMemberParams& params);
  ~FleetMember() override;
  FleetMember(const FleetMember&) = delete;
  FleetMember& operator=(const FleetMember&) = delete;

  /// Called after each exchange: where a simulated fleet works in rounds, it waits there for the
  /// others.
  std::function<void()> after_exchange;

  team_exploration::TeamView view() override;
  void claim(const std::optional<team_exploration::Claim>& claim) override;
  SearchView search_view() const override;
  void publish_search(const fleet_messages::SearchReport& report) override;
  /// The robot's snapshot with the map of all joined robots in place of its own.
  pipeline::Snapshot known();
  /// Sets the pose of a peer's map in this robot's map, whatever the readings show: of the maps
  /// that the two are building when the peer's first map is received.
  void set_known_pose(const std::string& peer, const team_map::RelativePose& relative) {
    known_poses_[peer] = relative;
  }
  /// Leaves the fleet.
  void leave();
  /// Exchanges messages at this time of the session, also after its end.
  void exchange(double now_s);

  /// The map of all joined robots in its frame; null before its first stop.
  const team_map::MergedMap* merged();
  const fleet::FleetExchange& fleet() const { return exchange_; }
  /// Number of stops that were too large to be sent: the others have nothing of that map from there
  /// on.
  std::size_t unsendable_stops() const { return unsendable_stops_; }
  const JoinLog& joins() const { return joins_; }

 private:
  void step();
  void publish_stops();
  void publish_pose(double now_s);
  void begin_map();
  void look();
  void apply_known_poses();
  /// Peers that may stand in the sonar's beam now.
  std::vector<team_exploration::Peer> peers() const;
  /// What the filter of unplaced peers classifies an echo by.
  team_exploration::UnplacedPeerFilter::Surroundings surroundings() const;

  session::RobotContext& robot_;
  FleetMemberParams params_;
  fleet::FleetExchange exchange_;
  TeamPicture picture_;
  JoinLog joins_;
  pipeline::ObservationFork behind_filter_;
  team_exploration::UnplacedPeerFilter unplaced_filter_;
  team_exploration::PeerEchoFilter filter_;
  std::unique_ptr<team_map::SubmapRecorder> recorder_;
  std::unique_ptr<SourceRecorder> source_recorder_;  ///< Null where it searches no source.
  std::optional<fleet_messages::SearchMessage> published_search_;
  std::map<std::string, team_map::RelativePose> known_poses_;  ///< By peer; those not received yet.
  session::RobotContext::StepListener listener_;
  fleet::FleetState state_;
  std::size_t published_stops_ = 0;  ///< Of the pipeline.
  std::size_t map_changes_ = 0;      ///< Of the atlas.
  std::size_t unsendable_stops_ = 0;
  double next_exchange_s_ = 0.0;
};

}  // namespace echomap::fleet_member
