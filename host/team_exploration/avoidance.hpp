// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "host/exploration/explorer.hpp"
#include "host/exploration/navigator.hpp"
#include "host/team_exploration/peer_guard.hpp"
#include "host/team_exploration/step_aside.hpp"
#include "host/team_exploration/team_view.hpp"

namespace echomap::team_exploration {

/// Values without another source are ours, chosen in simulation.
struct AvoidanceParams {
  std::string robot;  ///< Its name in the team.
  exploration::NavigatorParams navigator;
  PeerGuardParams guard;
  StepAsideParams aside;
  /// Period at which a robot that waits checks again.
  double look_again_s = 0.4;
  /// Time after which a peer in the way is assumed to stay: another goal, or another path, may be
  /// better.
  double patience_s = 6.0;
  /// A peer stays for which this robot has lost patience so many times, or made way in vain, and
  /// which has not moved this far meanwhile. Farther than robots move to let each other pass.
  std::size_t max_patiences = 3;
  double moved_m = 0.8;
  /// Distance by which each vain attempt widens the path that is left clear for the peer, and the
  /// floor that is planned around where it stays: the maps of the two differ, and so do their
  /// paths.
  double widen_m = 0.1;
  /// In a deadlock, the robot whose name comes last makes way at once, and each one before it this
  /// much later, in case those behind it cannot.
  double turn_s = 8.0;
  /// Shortest and longest time that a robot that has made way stays aside.
  double min_aside_s = 2.0;
  double max_aside_s = 20.0;
  /// Distance that it backs off from a peer that it has run into.
  double back_off_m = 0.08;
  /// Time for which it plans around the place where it has run into one: by the map of the two it
  /// may be elsewhere.
  double bump_memory_s = 60.0;
};

/// Counts of what meeting others came to.
struct Encounters {
  std::size_t waits = 0;          ///< Times that a robot was in the way.
  std::size_t bumps = 0;          ///< Times that it has run into one.
  std::size_t deadlocks = 0;      ///< Times that those in the way waited in turn for this robot.
  std::size_t made_way = 0;       ///< Times that this robot made way.
  std::size_t without_place = 0;  ///< Times that it found no place to make way to.
};

/// Keeps a robot off the others of its team: it waits until its path is free, and makes way for a
/// robot that it blocks. Names decide who makes way first; whoever has waited or made way in vain
/// three times plans around the other one.
class Avoidance {
 public:
  /// Throws std::invalid_argument for invalid parameters.
  explicit Avoidance(const AvoidanceParams& params);

  /// Continues to wait or to let others pass; empty where it does neither.
  std::optional<exploration::Motion> next(const pipeline::Snapshot& snapshot,
                                          const TeamView& view,
                                          exploration::MotionResult last);
  /// Returns the motion, or a wait where the motion would come too near to a peer.
  exploration::Motion checked(const pipeline::Snapshot& snapshot,
                              const TeamView& view,
                              const exploration::Motion& motion);
  /// Whether a motion with this result has run into a peer.
  bool has_run_into_peer(const pipeline::Snapshot& snapshot,
                         const TeamView& view,
                         exploration::MotionResult last);
  /// The motion away from that peer. Its own result does not count as running into one.
  exploration::Motion back_off(const pipeline::Snapshot& snapshot);
  /// Makes way for a robot that waits for this one; false where it need not, or cannot.
  bool make_way(const pipeline::Snapshot& snapshot, const TeamView& view);

  /// The other robots for planning: those that stay are obstacles with the room that they need; the
  /// rest is expected to move on.
  exploration::Company company(const TeamView& view, double now_s) const;

  /// Whether `company` closes floor where it has run into a peer.
  bool plans_around_bump(double now_s) const;
  bool is_making_way() const { return aside_.has_value(); }
  /// Name of the robot in its way; empty for none.
  std::string waits_for() const;
  /// Distance to keep between the middles of the two robots, metres, so that no motion comes too
  /// near.
  double keep_off_m(const Peer& peer) const { return guard_.keep_off_m(peer); }
  /// Whether that peer is expected to stay where it is, so that no path leads through it.
  bool stays(const Peer& peer) const;
  /// Whether those in its way wait in turn for this robot.
  bool is_in_deadlock() const { return held_ && held_->is_deadlock; }
  /// Whether it has waited so long, or gone so far, that another goal may be better. Returns true
  /// once.
  bool wants_another_goal();
  const Encounters& encounters() const { return encounters_; }

 private:
  /// A motion that waits until no robot is in its way.
  struct Held {
    exploration::Motion motion;
    std::string by;
    double since_s = 0.0;
    double turn_s = 0.0;  ///< When its last turn to make way was; at first as `since_s`.
    bool is_deadlock = false;
  };
  /// Times that this robot has waited or made way in vain for a peer near this place.
  struct LostPatience {
    Eigen::Vector2d at_m = Eigen::Vector2d::Zero();
    std::size_t times = 0;
  };
  /// Place at which it has run into a peer.
  struct Bump {
    Eigen::Vector2d at_m = Eigen::Vector2d::Zero();  ///< Middle of the peer, about.
    double since_s = 0.0;
  };
  /// State while another robot passes.
  struct Aside {
    std::string whom;
    double since_s = 0.0;
    bool has_arrived = false;
  };

  bool is_remembered(const Bump& bump, double now_s) const;
  exploration::Motion wait(const pipeline::Snapshot& snapshot, const TeamView& view, double now_s);
  void forget_peers_that_moved(const TeamView& view);
  void lose_patience(const TeamView& view, const std::string& whom);
  std::size_t times_in_vain(const Peer& peer) const;
  double attempts_since_it_stays(const Peer& peer) const;
  bool is_its_turn(const std::vector<std::string>& robots, double now_s);
  bool begin_aside(const pipeline::Snapshot& snapshot,
                   const TeamView& view,
                   const std::string& whom);
  std::optional<exploration::Motion> go_aside(const pipeline::Snapshot& snapshot,
                                              const TeamView& view);
  bool has_passed(const pipeline::Snapshot& snapshot, const TeamView& view) const;

  AvoidanceParams params_;
  PeerGuard guard_;
  exploration::Navigator navigator_;  ///< For the path aside.
  std::optional<Held> held_;
  std::optional<Aside> aside_;
  std::map<std::string, LostPatience> lost_patience_;  ///< By robot.
  std::vector<Bump> bumps_;
  bool backs_off_ = false;  ///< Whether the last motion was to back off.
  bool wants_another_goal_ = false;
  Encounters encounters_;
};

}  // namespace echomap::team_exploration
