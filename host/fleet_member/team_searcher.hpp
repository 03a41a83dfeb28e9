// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "host/exploration/explorer.hpp"
#include "host/fleet_member/search_board.hpp"
#include "host/source_search/source_readings.hpp"
#include "host/source_search/source_search.hpp"
#include "host/team_exploration/avoidance.hpp"

namespace echomap::fleet_member {

/// Values without another source are ours, chosen in simulation.
struct TeamSearcherParams {
  team_exploration::AvoidanceParams avoidance;
  /// Silence after which a robot is gone.
  double max_silent_s = 15.0;
  /// Robot time after which it ends at its stop limit.
  double max_s = std::numeric_limits<double>::infinity();
};

/// Searches a source as a member of a fleet: by its own readings and by those of all whose maps are
/// joined to its own, and not where others are about to read. It keeps off them and lets them pass.
/// The first one that is sure publishes its finding, and all of them end.
class TeamSearcher final : public exploration::Explorer {
 public:
  /// `board` and `readings`, those of the robot itself, must outlive this; `search` is shared with
  /// the caller, who reads its result. Throws std::invalid_argument for invalid parameters.
  TeamSearcher(SearchBoard& board,
               std::shared_ptr<source_search::SourceSearch> search,
               const source_search::SourceReadings& readings,
               const TeamSearcherParams& params);

  exploration::Motion next(const pipeline::Snapshot& snapshot,
                           exploration::MotionResult last) override;
  exploration::Intent intent() const override { return search_->intent(); }
  const team_exploration::Encounters& encounters() const { return avoidance_.encounters(); }
  /// Whether it waits for a robot that waits for it.
  bool is_in_deadlock() const { return avoidance_.is_in_deadlock(); }

 private:
  exploration::Motion decide(const pipeline::Snapshot& snapshot,
                             const team_exploration::TeamView& view,
                             exploration::MotionResult last);
  std::vector<source_search::FieldReading> all_readings(const pipeline::Snapshot& snapshot,
                                                        const SearchView& others);
  void publish();
  void claim();

  TeamSearcherParams params_;
  team_exploration::Avoidance avoidance_;
  SearchBoard& board_;
  std::shared_ptr<source_search::SourceSearch> search_;
  const source_search::SourceReadings& own_;
  /// Order in which the readings came: the map of each; "" for the robot's own.
  std::vector<std::string> order_;
  std::map<std::string, std::size_t> taken_;
  std::optional<team_exploration::Claim> claim_;  ///< As it was published.
};

}  // namespace echomap::fleet_member
