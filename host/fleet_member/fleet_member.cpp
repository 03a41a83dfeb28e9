// SPDX-License-Identifier: MIT
#include "host/fleet_member/fleet_member.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "host/exploration/company.hpp"
#include "host/geometry/parameter_validator.hpp"
#include "host/team_exploration/team_view.hpp"

namespace echomap::fleet_member {

namespace {

/// Session's times are whole microseconds.
constexpr double kSameTime = 1e-7;

}  // namespace

using pipeline::Snapshot;
using team_exploration::Claim;
using team_exploration::Peer;
using team_exploration::TeamView;

FleetMember::FleetMember(session::RobotContext& robot,
                         mqtt::MessageBus& bus,
                         const FleetMemberParams& params)
    : robot_(robot),
      params_(params),
      exchange_(bus, params.exchange),
      picture_(params.team),
      unplaced_filter_(
          behind_filter_,
          robot.profile().geometry,
          [this] { return surroundings(); },
          params.unplaced),
      filter_(
          unplaced_filter_,
          robot.profile().geometry,
          [this] { return robot_.atlas().pipeline().pose_estimate().T_map_robot; },
          [this](time::RobotTime /*stamp*/) { return peers(); },
          params.echoes),
      listener_(robot, [this] { step(); }),
      map_changes_(robot.atlas().changes()) {
  geometry::ParameterValidator("fleet member")
      .positive("exchange_period_s", params.exchange_period_s)
      .at_least("peer_drift_m_per_s", params.peer_drift_m_per_s, 0.0)
      .at_least("peer_drift_s", params.peer_drift_s, 0.0);
  robot_.put_before_maps(filter_);
  behind_filter_.add(robot_.atlas());
  begin_map();
}

FleetMember::~FleetMember() { robot_.put_before_maps(robot_.atlas()); }

void FleetMember::begin_map() {
  unplaced_filter_.forget_places();
  if (source_recorder_) {
    behind_filter_.remove(*source_recorder_);
  }
  if (recorder_) {
    behind_filter_.remove(*recorder_);
  }
  recorder_ = std::make_unique<team_map::SubmapRecorder>(robot_.profile().geometry);
  behind_filter_.add(*recorder_);
  if (params_.source) {
    source_recorder_ =
        std::make_unique<SourceRecorder>(*recorder_, *params_.source, params_.source_batch_s);
    behind_filter_.add(*source_recorder_);
  }
  published_stops_ = robot_.atlas().pipeline().snapshot().stops;
}

void FleetMember::step() {
  const double now_s = session::now_s(robot_.session());
  if (now_s >= next_exchange_s_) {
    exchange(now_s);
    const double periods = std::floor(now_s / params_.exchange_period_s + kSameTime);
    next_exchange_s_ = (periods + 1.0) * params_.exchange_period_s - kSameTime;
  }
}

void FleetMember::exchange(double now_s) {
  publish_stops();
  if (source_recorder_) {
    if (const auto batch = source_recorder_->take()) {
      exchange_.add_source_batch(*batch);
    }
  }
  publish_pose(now_s);
  exchange_.update(now_s);
  state_ = exchange_.state();
  if (after_exchange) {
    after_exchange();
  }
}

/// A stop whose scan the map has discarded is not published either.
void FleetMember::publish_stops() {
  if (map_changes_ != robot_.atlas().changes()) {
    map_changes_ = robot_.atlas().changes();
    exchange_.begin_map();
    begin_map();
    return;
  }
  const Snapshot snapshot = robot_.atlas().pipeline().snapshot();
  if (snapshot.stops == published_stops_) {
    return;
  }
  published_stops_ = snapshot.stops;
  if (snapshot.last_scan_fault != mapping::ScanFault::kNone) {
    recorder_->drop_last();
    return;
  }
  const auto& submaps = recorder_->submaps();
  auto poses = team_map::T_map_submaps(snapshot);
  if (submaps.empty() || poses.size() < submaps.size()) {
    return;
  }
  poses.erase(poses.begin(), poses.end() - static_cast<std::ptrdiff_t>(submaps.size()));
  if (!exchange_.add_submap(submaps.back())) {
    ++unsendable_stops_;
    return;
  }
  const auto covariance = robot_.atlas().pipeline().pose_estimate().covariance;
  exchange_.set_graph(poses, covariance.value_or(Eigen::Matrix3d::Zero()));
}

void FleetMember::publish_pose(double now_s) {
  const pipeline::PoseEstimate pose = robot_.atlas().pipeline().pose_estimate();
  exchange_.set_pose({pose.T_map_robot, pose.covariance.value_or(Eigen::Matrix3d::Zero())}, now_s);
}

void FleetMember::apply_known_poses() {
  for (const fleet::FleetRobot& robot : state_.robots) {
    const auto known = robot.maps.empty() ? known_poses_.end() : known_poses_.find(robot.name);
    if (known != known_poses_.end()) {
      picture_.set_known_pose(map_name(params_.exchange.robot, exchange_.map_number()),
                              map_name(robot.name, robot.map_number),
                              known->second);
      known_poses_.erase(known);
    }
  }
}

void FleetMember::look() {
  publish_stops();
  apply_known_poses();
  if (picture_.take(state_)) {
    // The first robot of a component publishes its alignment; the others could compute the same.
    exchange_.set_alignment(picture_.alignment(params_.exchange.robot, exchange_.map_number()));
  }
  joins_.look(session::now_s(robot_.session()),
              map_name(params_.exchange.robot, exchange_.map_number()),
              picture_.team());
}

TeamView FleetMember::view() {
  look();
  return picture_.view(state_, params_.exchange.robot, exchange_.map_number());
}

std::vector<Peer> FleetMember::peers() const {
  std::vector<Peer> peers = picture_.peers(state_, params_.exchange.robot, exchange_.map_number());
  for (Peer& peer : peers) {
    peer.position_stddev_m +=
        params_.peer_drift_m_per_s * std::min(peer.age_s, params_.peer_drift_s);
  }
  return peers;
}

team_exploration::UnplacedPeerFilter::Surroundings FleetMember::surroundings() const {
  const std::string map = map_name(params_.exchange.robot, exchange_.map_number());
  const auto unplaced = std::count_if(
      state_.robots.begin(), state_.robots.end(), [&](const fleet::FleetRobot& robot) {
        return robot.name != params_.exchange.robot && !picture_.relative_pose(map, robot);
      });
  const pipeline::RobotPipeline& pipeline = robot_.atlas().pipeline();
  return {pipeline.pose_estimate().T_map_robot,
          pipeline.snapshot().grid,
          static_cast<std::size_t>(unplaced)};
}

void FleetMember::claim(const std::optional<Claim>& claim) {
  exchange_.set_claims(claim ? std::vector{*claim} : std::vector<Claim>{});
}

SearchView FleetMember::search_view() const {
  const double place_stddev_m = params_.source ? params_.source->position_stddev_m : 0.0;
  const std::string& robot = params_.exchange.robot;
  return fleet_member::search_view(
      state_, picture_, map_name(robot, exchange_.map_number()), robot, place_stddev_m);
}

void FleetMember::publish_search(const fleet_messages::SearchReport& report) {
  const auto message = fleet_messages::to_message(report, exchange_.map_number());
  if (message && message != published_search_) {
    exchange_.set_search(report);
    published_search_ = message;
  }
}

Snapshot FleetMember::known() {
  return exploration::with_company(robot_.atlas().pipeline().snapshot(),
                                   team_exploration::company_of(view()));
}

const team_map::MergedMap* FleetMember::merged() {
  look();
  const std::string map = map_name(params_.exchange.robot, exchange_.map_number());
  return picture_.team().component_of(map) != nullptr ? &picture_.team().merged(map) : nullptr;
}

void FleetMember::leave() {
  if (source_recorder_) {
    if (const auto batch = source_recorder_->take_rest()) {
      exchange_.add_source_batch(*batch);
    }
  }
  exchange_.leave();
}

}  // namespace echomap::fleet_member
