// SPDX-License-Identifier: MIT
#include "host/team_exploration/avoidance.hpp"

#include <algorithm>
#include <utility>

#include "host/exploration/planning_map.hpp"
#include "host/geometry/parameter_validator.hpp"
#include "host/team_exploration/claims.hpp"
#include "host/time/robot_seconds.hpp"

namespace echomap::team_exploration {
namespace {

using exploration::Motion;
using exploration::MotionResult;
using exploration::Stand;
using pipeline::Snapshot;

const Peer* find_peer(const TeamView& view, const std::string& robot) {
  const auto found = std::find_if(
      view.peers.begin(), view.peers.end(), [&](const Peer& peer) { return peer.robot == robot; });
  return found == view.peers.end() ? nullptr : &*found;
}

}  // namespace

Avoidance::Avoidance(const AvoidanceParams& params)
    : params_(params), guard_(params.guard), navigator_(params.navigator) {
  geometry::ParameterValidator("avoidance")
      .require(!params.robot.empty(), "the robot needs a name")
      .positive("look_again_s", params.look_again_s)
      .positive("patience_s", params.patience_s)
      .positive("max_patiences", params.max_patiences)
      .positive("moved_m", params.moved_m)
      .at_least("widen_m", params.widen_m, 0.0)
      .positive("turn_s", params.turn_s)
      .at_least("min_aside_s", params.min_aside_s, 0.0)
      .at_least("max_aside_s", params.max_aside_s, params.min_aside_s)
      .at_least("back_off_m", params.back_off_m, 0.0)
      .at_least("bump_memory_s", params.bump_memory_s, 0.0);
}

std::string Avoidance::waits_for() const {
  if (aside_) {
    return aside_->whom;
  }
  return held_ ? held_->by : "";
}

bool Avoidance::wants_another_goal() { return std::exchange(wants_another_goal_, false); }

std::optional<Motion> Avoidance::next(const Snapshot& snapshot,
                                      const TeamView& view,
                                      MotionResult last) {
  forget_peers_that_moved(view);
  if (aside_) {
    aside_->has_arrived = aside_->has_arrived || exploration::is_stopped(snapshot, last);
    if (auto motion = go_aside(snapshot, view)) {
      return motion;
    }
    if (!has_passed(snapshot, view)) {
      lose_patience(view, aside_->whom);
    }
    aside_.reset();
    wants_another_goal_ = true;
  }
  if (!held_) {
    return std::nullopt;
  }
  const Motion motion = held_->motion;
  const Peer* peer = guard_.in_the_way(motion, snapshot.latest.T_map_robot, view.peers);
  if (peer == nullptr) {
    held_.reset();
    return motion;
  }
  held_->by = peer->robot;
  return wait(snapshot, view, time::robot_seconds(snapshot.latest.stamp));
}

Motion Avoidance::checked(const Snapshot& snapshot, const TeamView& view, const Motion& motion) {
  const Peer* peer = guard_.in_the_way(motion, snapshot.latest.T_map_robot, view.peers);
  if (peer == nullptr) {
    return motion;
  }
  const double now_s = time::robot_seconds(snapshot.latest.stamp);
  ++encounters_.waits;
  held_ = Held{motion, peer->robot, now_s, now_s, false};
  return wait(snapshot, view, now_s);
}

/// Waits until the motion can be made; in a deadlock, until it is this robot's turn to make way.
/// After its patience, or enough turns, it wants another goal.
Motion Avoidance::wait(const Snapshot& snapshot, const TeamView& view, double now_s) {
  const auto robots = deadlock(view, params_.robot, held_->by);
  if (!robots.empty() && is_its_turn(robots, now_s)) {
    held_->turn_s = now_s;
    if (begin_aside(snapshot, view, held_->by)) {
      held_.reset();
      return Stand{params_.look_again_s};
    }
  }
  const double all_turns_s = params_.turn_s * static_cast<double>(robots.size());
  if (now_s - held_->since_s >= std::max(params_.patience_s, 2.0 * all_turns_s)) {
    const std::string whom = held_->by;
    lose_patience(view, whom);
    held_.reset();
    wants_another_goal_ = true;
    // From within the distance to keep no path round it can be planned: first away from it.
    const Peer* peer = find_peer(view, whom);
    if (peer != nullptr && attempts_since_it_stays(*peer) > 0.0) {
      begin_aside(snapshot, view, whom);
    }
  }
  return Stand{params_.look_again_s};
}

void Avoidance::forget_peers_that_moved(const TeamView& view) {
  for (const Peer& peer : view.peers) {
    if (times_in_vain(peer) == 0) {
      lost_patience_.erase(peer.robot);
    }
  }
}

void Avoidance::lose_patience(const TeamView& view, const std::string& whom) {
  if (const Peer* peer = find_peer(view, whom)) {
    const std::size_t times = times_in_vain(*peer);
    LostPatience& lost = lost_patience_[whom];
    lost = {times == 0 ? peer->T_map_robot.position_m() : lost.at_m, times + 1};
  }
}

/// Zero where the peer has moved away since.
std::size_t Avoidance::times_in_vain(const Peer& peer) const {
  const auto lost = lost_patience_.find(peer.robot);
  const bool is_there =
      lost != lost_patience_.end() &&
      (lost->second.at_m - peer.T_map_robot.position_m()).norm() <= params_.moved_m;
  return is_there ? lost->second.times : 0;
}

/// Attempts to get round it that were in vain, too: the path came too near by a few centimetres.
double Avoidance::attempts_since_it_stays(const Peer& peer) const {
  const std::size_t times = times_in_vain(peer);
  return times > params_.max_patiences ? static_cast<double>(times - params_.max_patiences) : 0.0;
}

bool Avoidance::stays(const Peer& peer) const {
  return peer.stays || times_in_vain(peer) >= params_.max_patiences;
}

/// The robots of a deadlock take turns from the last name on.
bool Avoidance::is_its_turn(const std::vector<std::string>& robots, double now_s) {
  encounters_.deadlocks += std::exchange(held_->is_deadlock, true) ? 0 : 1;
  const auto later = std::count_if(robots.begin(), robots.end(), [&](const std::string& other) {
    return other > params_.robot;
  });
  return now_s - held_->turn_s >= params_.turn_s * static_cast<double>(later);
}

bool Avoidance::begin_aside(const Snapshot& snapshot,
                            const TeamView& view,
                            const std::string& whom) {
  const Peer* peer = find_peer(view, whom);
  if (peer == nullptr) {
    return false;
  }
  const Snapshot known = exploration::with_company(snapshot, company_of(view));
  const auto map = exploration::planning_map(known, 0.0, params_.navigator.costs.robot_radius_m);
  const ClearPath path{expected_path(map, *peer, claim_of(view, whom), params_.aside),
                       guard_.keep_off_m(*peer) + map.resolution_m() +
                           params_.widen_m * static_cast<double>(std::min(times_in_vain(*peer),
                                                                          params_.max_patiences))};
  const Eigen::Vector2d here_m = snapshot.latest.T_map_robot.position_m();
  const auto place = passing_place(map, here_m, view.peers, path, params_.aside);
  if (!place) {
    ++encounters_.without_place;
    return false;
  }
  ++encounters_.made_way;
  navigator_.set_hypothetical_map(map, known);
  navigator_.follow_path_to(snapshot.latest.T_map_robot, place->at_m, place->cost_m);
  aside_ = Aside{whom, time::robot_seconds(snapshot.latest.stamp), false};
  return true;
}

bool Avoidance::make_way(const Snapshot& snapshot, const TeamView& view) {
  return !aside_ && std::any_of(view.claims.begin(), view.claims.end(), [&](const Claim& claim) {
    return claim.waits_for == params_.robot && begin_aside(snapshot, view, claim.robot);
  });
}

/// Drives to the place, and waits there until the other robot has passed; empty where it has.
std::optional<Motion> Avoidance::go_aside(const Snapshot& snapshot, const TeamView& view) {
  const double now_s = time::robot_seconds(snapshot.latest.stamp);
  if (now_s - aside_->since_s >= params_.max_aside_s) {
    return std::nullopt;
  }
  if (now_s - aside_->since_s >= params_.min_aside_s && has_passed(snapshot, view)) {
    return std::nullopt;
  }
  if (!aside_->has_arrived) {
    const auto motion = navigator_.next(snapshot.latest.T_map_robot);
    aside_->has_arrived = !motion;
    if (motion && guard_.in_the_way(*motion, snapshot.latest.T_map_robot, view.peers) == nullptr) {
      return motion;
    }
  }
  return Stand{params_.look_again_s};
}

/// Whether it no longer waits for this robot, and does not come nearer.
bool Avoidance::has_passed(const Snapshot& snapshot, const TeamView& view) const {
  const Peer* peer = find_peer(view, aside_->whom);
  const Claim* claim = claim_of(view, aside_->whom);
  if (peer == nullptr || claim == nullptr) {
    return true;
  }
  const Eigen::Vector2d from_peer_m =
      peer->T_map_robot.inverse() * snapshot.latest.T_map_robot.position_m();
  return claim->waits_for != params_.robot &&
         (from_peer_m.x() < 0.0 || from_peer_m.norm() > 4.0 * guard_.keep_off_m(*peer));
}

bool Avoidance::has_run_into_peer(const Snapshot& snapshot,
                                  const TeamView& view,
                                  MotionResult last) {
  constexpr double kReachM = 0.15;
  if (std::exchange(backs_off_, false)) {
    return false;
  }
  const bool is_stopped = exploration::is_stopped(snapshot, last);
  return is_stopped && std::any_of(view.peers.begin(), view.peers.end(), [&](const Peer& peer) {
           const double apart_m = guard_.distance_m(snapshot.latest.T_map_robot.position_m(), peer);
           return apart_m < guard_.keep_off_m(peer) + kReachM;
         });
}

Motion Avoidance::back_off(const Snapshot& snapshot) {
  ++encounters_.bumps;
  backs_off_ = true;
  const double now_s = time::robot_seconds(snapshot.latest.stamp);
  std::erase_if(bumps_, [&](const Bump& bump) { return !is_remembered(bump, now_s); });
  const Eigen::Vector2d ahead_m(2.0 * params_.guard.robot_radius_m, 0.0);
  bumps_.push_back({snapshot.latest.T_map_robot * ahead_m, now_s});
  held_.reset();
  wants_another_goal_ = true;
  return exploration::Drive{-params_.back_off_m};
}

bool Avoidance::is_remembered(const Bump& bump, double now_s) const {
  return now_s - bump.since_s < params_.bump_memory_s;
}

bool Avoidance::plans_around_bump(double now_s) const {
  return std::ranges::any_of(bumps_, [&](const Bump& bump) { return is_remembered(bump, now_s); });
}

exploration::Company Avoidance::company(const TeamView& view, double now_s) const {
  exploration::Company company = company_of(view);
  for (std::size_t i = 0; i < view.peers.size(); ++i) {
    if (stays(view.peers[i])) {
      exploration::OccupiedFloor& floor = company.standing[i];
      floor.is_closed = true;
      floor.radius_m = keep_off_m(view.peers[i]) - params_.guard.robot_radius_m +
                       params_.widen_m * attempts_since_it_stays(view.peers[i]);
    }
  }
  for (const Bump& bump : bumps_) {
    if (is_remembered(bump, now_s)) {
      company.standing.push_back({bump.at_m, params_.guard.robot_radius_m, true});
    }
  }
  return company;
}

}  // namespace echomap::team_exploration
