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

/// Who this robot is in its fleet. Values are ours.
struct FleetMemberParams {
  fleet::FleetExchangeParams exchange;
  team_map::TeamMapParams team;
  team_exploration::PeerEchoParams echoes;
  team_exploration::UnplacedPeerParams unplaced;
  /// Messages are exchanged at whole multiples of this, seconds of the session's time.
  double exchange_period_s = 0.1;
  /// A peer that drives may be so much farther from where it told to be, for each second since,
  double peer_drift_m_per_s = 0.1;
  /// up to so many: one that tells nothing for longer stands.
  double peer_drift_s = 2.0;
  /// Of a robot that searches a source: how it reads, and for how long in one batch, seconds.
  std::optional<source_search::SourceReadingsParams> source;
  double source_batch_s = 4.0;
};

/// A connected robot as a member of a fleet: tells each stop, its pose and its claim, and has what
/// the others have told in its own map frame. Echoes and contacts of the others are kept out of
/// its map.
class FleetMember final : public SearchBoard {
 public:
  /// `robot` has begun its maps and is not open yet; it and the bus outlive this. Throws as
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
  void tell_search(const fleet_messages::SearchReport& report) override;
  /// The robot's snapshot with the map of all joined robots in place of its own.
  pipeline::Snapshot known();
  /// Where the map that a peer makes lies in this robot's map, whatever walls say: of the maps that
  /// the two make when the peer is heard first.
  void tell(const std::string& peer, const team_map::RelativePose& relative) {
    told_[peer] = relative;
  }
  /// Says good-bye.
  void leave();
  /// Exchanges messages at this time of the session, which has ended, too.
  void exchange(double now_s);

  /// The map of all joined robots in its frame; null before its first stop.
  const team_map::MergedMap* merged();
  const fleet::FleetExchange& fleet() const { return exchange_; }
  /// Stops that were too large to be sent: the others have nothing of that map from there on.
  std::size_t unsendable_stops() const { return unsendable_stops_; }
  const JoinLog& joins() const { return joins_; }

 private:
  void step();
  void tell_stops();
  void tell_pose(double now_s);
  void begin_map();
  void look();
  void use_told();
  /// Those that may stand in the sonar's beam now.
  std::vector<team_exploration::Peer> peers() const;
  /// What an echo is weighed by while it is not known where others are.
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
  std::unique_ptr<SourceRecorder> source_recorder_;  ///< Null of a robot that does not search.
  std::optional<fleet_messages::SearchMessage> told_search_;
  std::map<std::string, team_map::RelativePose> told_;  ///< By peers that were not heard yet.
  session::RobotContext::StepListener listener_;
  fleet::FleetState state_;
  std::size_t told_stops_ = 0;   ///< Of the pipeline.
  std::size_t map_changes_ = 0;  ///< Of the atlas.
  std::size_t unsendable_stops_ = 0;
  double next_exchange_s_ = 0.0;
};

}  // namespace echomap::fleet_member
