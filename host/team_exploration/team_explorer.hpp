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
  /// A look is said to show floor so far off.
  double reach_m = 2.0;
  /// Robots that have told nothing for so long are gone, and so are their claims.
  double max_silent_s = 15.0;
  /// A claim is told again when its utility has changed by this share.
  double rebid_share = 0.2;
  /// A robot that waits for others to finish decides again so often.
  double decide_again_s = 5.0;
  /// And it has finished when nobody has claimed anything for so long.
  double idle_s = 10.0;
};

/// Explores as one of a team, by `frontier`: decides by the map of all, leaves to others what they
/// claim (after Burgard et al. 2005, with an auction that has no auctioneer), keeps off them and
/// lets them pass. It has finished when the map of all is complete; while what is left is claimed
/// by others it waits, and takes over what they give back.
class TeamExplorer final : public exploration::Explorer {
 public:
  /// `board` outlives this. Throws std::invalid_argument for invalid parameters.
  TeamExplorer(TeamBoard& board, const TeamExplorerParams& params);

  exploration::Motion next(const pipeline::Snapshot& snapshot,
                           exploration::MotionResult last) override;
  exploration::Intent intent() const override { return frontier_.intent(); }
  const Encounters& encounters() const { return avoidance_.encounters(); }
  bool is_in_deadlock() const { return avoidance_.is_in_deadlock(); }
  /// Times that another robot's claim was the better one.
  std::size_t lost_bids() const { return lost_bids_; }

 private:
  exploration::Motion decide(const pipeline::Snapshot& snapshot, exploration::MotionResult last);
  bool has_lost_goal();
  exploration::Motion explore(const pipeline::Snapshot& snapshot, exploration::MotionResult last);
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
  std::optional<double> idle_since_s_;    ///< While it does, and nobody claims anything.
  /// The goal that it has claimed, and when.
  std::optional<exploration::Viewpoint> goal_;
  double claimed_s_ = 0.0;
  std::optional<Claim> claim_;  ///< As it was told.
  std::size_t lost_bids_ = 0;
};

}  // namespace echomap::team_exploration
