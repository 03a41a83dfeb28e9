// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "host/exploration/explorer.hpp"
#include "host/exploration/frontier.hpp"
#include "host/team_exploration/avoidance.hpp"
#include "host/team_exploration/team_board.hpp"

namespace echomap::team_exploration {

/// Values without another source are ours, chosen in simulation.
struct TeamExplorerParams {
  exploration::FrontierParams frontier;
  AvoidanceParams avoidance;
  /// Distance up to which a look is assumed to show floor.
  double reach_m = 2.0;
  /// Silence after which a robot is gone, and so are its claims.
  double max_silent_s = 15.0;
  /// A claim is published again when its utility has changed by this share.
  double rebid_share = 0.2;
  /// Period at which a robot that waits for others to finish decides again.
  double decide_again_s = 5.0;
  /// A robot has finished when no other has claimed anything for this long.
  double idle_s = 10.0;
};

/// Explores as a member of a team with strategy `frontier`: decides by the map of all, leaves to
/// others what they claim (after Burgard et al. 2005, with an auction that has no auctioneer),
/// keeps off them and lets them pass. It has finished when the map of all is complete; while the
/// rest is claimed by others it waits, and takes over what they give back.
class TeamExplorer final : public exploration::Explorer {
 public:
  /// `board` outlives this. Throws std::invalid_argument for invalid parameters.
  TeamExplorer(TeamBoard& board, const TeamExplorerParams& params);

  exploration::Motion next(const pipeline::Snapshot& snapshot,
                           exploration::MotionResult last) override;
  exploration::Intent intent() const override { return frontier_.intent(); }
  const Encounters& encounters() const { return avoidance_.encounters(); }
  bool is_in_deadlock() const { return avoidance_.is_in_deadlock(); }
  /// Number of times that another robot's claim was the better one.
  std::size_t lost_bids() const { return lost_bids_; }

 private:
  exploration::Motion decide(const pipeline::Snapshot& snapshot, exploration::MotionResult last);
  bool has_lost_goal();
  exploration::Motion explore(const pipeline::Snapshot& snapshot, exploration::MotionResult last);
  bool waits_with(const exploration::Motion& motion, double now_s);
  bool is_blocked_for_now() const;
  bool are_all_idle(double now_s);
  void bid(double now_s, bool has_finished);

  TeamExplorerParams params_;
  exploration::Frontier frontier_;
  Avoidance avoidance_;
  TeamBoard& board_;
  TeamView view_;
  std::shared_ptr<const mapping::OccupancyGrid> decided_by_;  ///< The map of all at that time.
  std::vector<Claim> lost_to_;            ///< Better claims that it has decided by, on this way.
  std::optional<double> decide_again_s_;  ///< While it waits for others to finish.
  std::optional<double> idle_since_s_;    ///< While it does, and no robot claims anything.
  /// The goal that it has claimed, and when.
  std::optional<exploration::Viewpoint> goal_;
  double claimed_s_ = 0.0;
  std::optional<Claim> claim_;  ///< As it was published.
  std::size_t lost_bids_ = 0;
};

}  // namespace echomap::team_exploration
