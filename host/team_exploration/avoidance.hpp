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
  /// A robot that waits looks again so often.
  double look_again_s = 0.4;
  /// After so long a peer in the way is taken for one that stays: another goal, or another way, may
  /// be the better one.
  double patience_s = 6.0;
  /// One in the way for so often its patience, who has not moved this far meanwhile, stays.
  std::size_t max_patiences = 3;
  double moved_m = 0.3;
  /// Of a deadlock the robot whose name comes last makes way at once, and each before it so much
  /// later, for the case that those behind it cannot.
  double turn_s = 8.0;
  /// A robot that has made way stays there at least and at most so long.
  double min_aside_s = 2.0;
  double max_aside_s = 20.0;
  /// It goes back so far from a peer that it has run into.
  double back_off_m = 0.08;
};

/// What became of meeting others.
struct Encounters {
  std::size_t waits = 0;          ///< Times that a robot stood in the way.
  std::size_t bumps = 0;          ///< Times that one was run into.
  std::size_t deadlocks = 0;      ///< Times that those in the way waited in turn for this robot.
  std::size_t made_way = 0;       ///< Times that this robot went out of the way.
  std::size_t without_place = 0;  ///< Times that it would have, and there was no place.
};

/// Keeps a robot off the others of its team: it waits until its way is free, and makes way for whom
/// it holds up. Who makes way goes by name, so that no two wait for each other for ever.
class Avoidance {
 public:
  /// Throws std::invalid_argument for invalid parameters.
  explicit Avoidance(const AvoidanceParams& params);

  /// Goes on with what it is at, letting others pass or waiting; empty where it is at nothing.
  std::optional<exploration::Motion> next(const pipeline::Snapshot& snapshot,
                                          const TeamView& view,
                                          exploration::MotionResult last);
  /// The motion, or a wait where it would come too near to a peer.
  exploration::Motion checked(const pipeline::Snapshot& snapshot,
                              const TeamView& view,
                              const exploration::Motion& motion);
  /// Whether a motion that ended so has run into a peer.
  bool has_run_into_peer(const pipeline::Snapshot& snapshot,
                         const TeamView& view,
                         exploration::MotionResult last) const;
  /// The way back from there.
  exploration::Motion back_off();
  /// Makes way for a robot that waits for this one; false where it need not, or cannot.
  bool make_way(const pipeline::Snapshot& snapshot, const TeamView& view);

  /// The others, of whom those who stay are walls, with the room that is left to them; the rest
  /// will be gone.
  exploration::Company company(const TeamView& view) const;

  bool is_making_way() const { return aside_.has_value(); }
  /// Who is in its way; empty for nobody.
  std::string waits_for() const;
  /// Between the middles of the two robots, so that no motion comes too near.
  double keep_off_m(const Peer& peer) const { return guard_.keep_off_m(peer); }
  /// Whether no way leads past that peer: it stays where it is.
  bool stays(const Peer& peer) const;
  /// Whether those in its way wait in turn for this robot.
  bool is_in_deadlock() const { return held_ && held_->is_deadlock; }
  /// Whether it has waited so long, or gone so far, that another goal may be better. Says so once.
  bool wants_another_goal();
  const Encounters& encounters() const { return encounters_; }

 private:
  /// A motion that waits until nobody is in its way.
  struct Held {
    exploration::Motion motion;
    std::string by;
    double since_s = 0.0;
    double turn_s = 0.0;  ///< When its last turn to make way was; at first as `since_s`.
    bool is_deadlock = false;
  };
  /// How often the robot has lost its patience with somebody who stood there.
  struct LostPatience {
    Eigen::Vector2d at_m = Eigen::Vector2d::Zero();
    std::size_t times = 0;
  };
  /// While another one passes.
  struct Aside {
    std::string whom;
    double since_s = 0.0;
    bool has_arrived = false;
  };

  exploration::Motion wait(const pipeline::Snapshot& snapshot, const TeamView& view, double now_s);
  void lose_patience(const TeamView& view);
  bool is_its_turn(const std::vector<std::string>& robots, double now_s);
  bool begin_aside(const pipeline::Snapshot& snapshot,
                   const TeamView& view,
                   const std::string& whom);
  std::optional<exploration::Motion> go_aside(const pipeline::Snapshot& snapshot,
                                              const TeamView& view);
  bool has_passed(const pipeline::Snapshot& snapshot, const TeamView& view) const;

  AvoidanceParams params_;
  PeerGuard guard_;
  exploration::Navigator navigator_;  ///< On the way aside.
  std::optional<Held> held_;
  std::optional<Aside> aside_;
  std::map<std::string, LostPatience> lost_patience_;  ///< By robot.
  bool wants_another_goal_ = false;
  Encounters encounters_;
};

}  // namespace echomap::team_exploration
