// SPDX-License-Identifier: MIT
#include "host/team_exploration/team_explorer.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include "host/geometry/parameter_validator.hpp"
#include "host/team_exploration/claims.hpp"
#include "host/time/robot_seconds.hpp"

namespace echomap::team_exploration {
namespace {

using exploration::Finished;
using exploration::FinishReason;
using exploration::Motion;
using exploration::MotionResult;
using exploration::Stand;
using pipeline::Snapshot;

/// What a goal is worth now that a part of its time has passed: no less than at first.
double utility_of(const exploration::Viewpoint& goal, double passed_s) {
  if (goal.gain_per_s <= 0.0) {
    return 0.0;
  }
  constexpr double kStopS = 5.0;
  const double left_s = std::max(kStopS, goal.view.gain_m2 / goal.gain_per_s - passed_s);
  return std::max(goal.gain_per_s, goal.view.gain_m2 / left_s);
}

/// Whether a claim has changed so much that it is published again.
bool differs(const std::optional<Claim>& one, const std::optional<Claim>& other, double share) {
  if (!one || !other) {
    return one.has_value() != other.has_value();
  }
  return one->at_m != other->at_m || one->waits_for != other->waits_for ||
         std::abs(one->utility - other->utility) > share * other->utility;
}

}  // namespace

TeamExplorer::TeamExplorer(TeamBoard& board, const TeamExplorerParams& params)
    : params_(params), frontier_(params.frontier), avoidance_(params.avoidance), board_(board) {
  geometry::ParameterValidator("team explorer")
      .positive("reach_m", params.reach_m)
      .positive("max_silent_s", params.max_silent_s)
      .at_least("rebid_share", params.rebid_share, 0.0)
      .positive("decide_again_s", params.decide_again_s)
      .at_least("idle_s", params.idle_s, 0.0);
}

Motion TeamExplorer::next(const Snapshot& snapshot, MotionResult last) {
  view_ = without_silent(board_.view(), params_.max_silent_s);
  const Motion motion = decide(snapshot, last);
  bid(time::robot_seconds(snapshot.latest.stamp), std::holds_alternative<Finished>(motion));
  return motion;
}

Motion TeamExplorer::decide(const Snapshot& snapshot, MotionResult last) {
  const bool is_driving = frontier_.goal() || avoidance_.is_making_way();
  const bool has_run_into_peer = avoidance_.has_run_into_peer(snapshot, view_, last);
  if (is_driving && has_run_into_peer) {
    return avoidance_.back_off(snapshot);
  }
  if (auto motion = avoidance_.next(snapshot, view_, last)) {
    return *motion;
  }
  const bool has_new_map = view_.grid != decided_by_;
  if (avoidance_.wants_another_goal() || has_lost_goal() || has_new_map) {
    frontier_.reconsider();
  }
  return avoidance_.checked(snapshot, view_, explore(snapshot, last));
}

/// Whether another robot's claim of the same floor is better, and this robot has not decided by it
/// yet.
bool TeamExplorer::has_lost_goal() {
  constexpr double kSameM = 0.1;
  if (!claim_ || !frontier_.goal()) {
    lost_to_.clear();
    return false;
  }
  for (const Claim& other : view_.claims) {
    const bool is_same = (other.at_m - claim_->at_m).norm() < params_.frontier.contest_m;
    const bool is_known = std::any_of(lost_to_.begin(), lost_to_.end(), [&](const Claim& known) {
      return known.robot == other.robot && (known.at_m - other.at_m).norm() < kSameM;
    });
    if (is_same && !is_known && beats(other, *claim_)) {
      lost_to_.push_back(other);
      ++lost_bids_;
      return true;
    }
  }
  return false;
}

Motion TeamExplorer::explore(const Snapshot& snapshot, MotionResult last) {
  const double now_s = time::robot_seconds(snapshot.latest.stamp);
  if (decide_again_s_ && now_s < *decide_again_s_ && view_.grid == decided_by_) {
    avoidance_.make_way(snapshot, view_);
    return Stand{params_.avoidance.look_again_s};
  }
  frontier_.set_company(avoidance_.company(view_, now_s));
  const Motion motion = frontier_.next(snapshot, last);
  decided_by_ = view_.grid;
  if (!waits_with(motion, now_s)) {
    decide_again_s_.reset();
    idle_since_s_.reset();
    return motion;
  }
  decide_again_s_ = now_s + params_.decide_again_s;
  return Stand{params_.avoidance.look_again_s};
}

/// Whether a robot that sees nothing left to do waits all the same: others may give floor back, or
/// leave the floor that it plans around.
bool TeamExplorer::waits_with(const Motion& motion, double now_s) {
  const auto* finished = std::get_if<Finished>(&motion);
  if (finished == nullptr) {
    return false;
  }
  const bool may_change = finished->reason == FinishReason::kComplete || is_blocked_for_now();
  return avoidance_.plans_around_bump(now_s) || (may_change && !are_all_idle(now_s));
}

/// Whether it plans around a peer that may yet move on.
bool TeamExplorer::is_blocked_for_now() const {
  return std::ranges::any_of(
      view_.peers, [&](const Peer& peer) { return !peer.stays && avoidance_.stays(peer); });
}

/// Whether no robot has claimed anything for a while: a claim may be on its way, and a robot that
/// has left makes way for no other.
bool TeamExplorer::are_all_idle(double now_s) {
  if (!view_.claims.empty()) {
    idle_since_s_.reset();
    return false;
  }
  const bool is_alone = std::ranges::all_of(view_.peers, &Peer::stays);
  idle_since_s_ = idle_since_s_.value_or(now_s);
  return is_alone || now_s - *idle_since_s_ >= params_.idle_s;
}

/// Claims the goal that the robot drives to; the claim holds while it looks from there. A robot
/// that has finished or waits for others to finish claims nothing.
void TeamExplorer::bid(double now_s, bool has_finished) {
  std::optional<Claim> claim = has_finished || decide_again_s_ ? std::nullopt : claim_;
  if (const auto goal = has_finished ? std::nullopt : frontier_.goal()) {
    if (!goal_ || goal_->at_m != goal->at_m) {
      goal_ = goal;
      claimed_s_ = now_s;
    }
    claim = Claim{params_.avoidance.robot,
                  goal->at_m,
                  utility_of(*goal_, now_s - claimed_s_),
                  params_.reach_m,
                  ""};
  }
  if (claim) {
    claim->waits_for = avoidance_.waits_for();
  }
  if (differs(claim, claim_, params_.rebid_share)) {
    claim_ = claim;
    board_.claim(claim);
  }
}

}  // namespace echomap::team_exploration
