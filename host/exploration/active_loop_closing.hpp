// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "host/exploration/travel_field.hpp"
#include "host/mapping/raster_map.hpp"
#include "host/pipeline/snapshot.hpp"

namespace echomap::exploration {

/// Ours, chosen in simulation.
struct ActiveLoopClosingParams {
  /// The robot goes back where the standard deviation of its position is greater than this.
  double max_position_stddev_m = 0.5;
  /// The stops to go back to are those made with at most this share of max_position_stddev_m.
  double max_known_share = 0.5;
  /// A goal so near to such a stop has the same walls in sight: no need to go back first.
  double same_walls_m = 1.0;
  /// Where the deviation is still great after going back, the limit is this factor times it.
  double limit_growth = 1.5;
};

/// The place of an earlier stop and the cost of the way there.
struct EarlierStop {
  Eigen::Vector2d at_m = Eigen::Vector2d::Zero();
  double cost_m = 0.0;
};

/// Out of sight of known walls a robot has its odometry alone: decides when it goes back to a stop
/// where its position was known, to hear the walls of that stop again (active loop closing;
/// Stachniss, Haehnel and Burgard, IROS 2004).
class ActiveLoopClosing {
 public:
  /// Throws std::invalid_argument for invalid parameters.
  explicit ActiveLoopClosing(const ActiveLoopClosingParams& params);

  /// After each stop, at which the snapshot has its scan or not.
  void add_stop(const pipeline::Snapshot& snapshot);
  /// The stop to go back to before `goal_m`, the cheapest of those where the position was known.
  /// Empty where the position is known well enough, where `goal_m` is beside such a stop, and
  /// without a way. `travel` is that over `map`.
  std::optional<EarlierStop> choose(const pipeline::Snapshot& snapshot,
                                    const Eigen::Vector2d& goal_m,
                                    const TravelField& travel,
                                    const mapping::RasterMap& map);

 private:
  std::vector<Eigen::Vector2d> known_stops_m(const pipeline::Snapshot& snapshot) const;

  ActiveLoopClosingParams params_;
  double limit_m_;
  bool is_returning_ = false;
  std::vector<std::size_t> known_scans_;  ///< Indices of the snapshot's scans.
  std::size_t scans_ = 0;
};

}  // namespace echomap::exploration
