// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "host/exploration/cost_grid.hpp"
#include "host/source_search/dwell_lattice.hpp"
#include "host/source_search/information_gain.hpp"

namespace echomap::source_search {

/// Values without another source are ours, chosen in simulation.
struct DwellChoiceParams {
  /// Number of samples that represent the posterior.
  std::size_t samples = 64;
  /// Distance between candidate places.
  double spacing_m = 0.8;
  /// Places that take longer to get to are not considered.
  double max_path_s = 60.0;
  /// How long to stand and count at the end of a path, where that is worth it.
  double dwell_s = 3.0;
  /// Speed that the duration of a path is computed with; the sensor counts meanwhile.
  double speed_m_per_s = 0.2;
  /// Added to the duration of each plan, so that a short one is not followed by one that is as
  /// good.
  double overhead_s = 3.0;
  /// A goal is given up for another one with this factor of gain per second.
  double better = 1.25;
};

/// A path to count along, and a goal to count at.
struct DwellPlan {
  Eigen::Vector2d goal_m = Eigen::Vector2d::Zero();
  double dwell_s = 0.0;                ///< Time to stand at the goal.
  std::vector<PlannedDwell> readings;  ///< On the path and at the goal, in their order.
  double gain = 0.0;                   ///< InformationGain, in nats.
  double time_s = 0.0;
  double gain_per_s = 0.0;  ///< Including the overhead.
};

/// Chooses where to count next: of all paths to places in reach, the one with the most expected
/// information per second, given what others are about to count.
class DwellChoice {
 public:
  /// Throws std::invalid_argument for invalid parameters.
  explicit DwellChoice(const DwellChoiceParams& params);

  /// The best plan; empty where no path leads anywhere. `offset` from 0 to 1 chooses the samples;
  /// `current_m` is the goal that the robot drives to now.
  std::optional<DwellPlan> choose(const SourceBelief& belief,
                                  const exploration::CostGrid& costs,
                                  const DwellLattice& lattice,
                                  const Eigen::Vector2d& from_m,
                                  std::span<const PlannedDwell> others,
                                  std::optional<Eigen::Vector2d> current_m,
                                  double offset) const;

 private:
  DwellChoiceParams params_;
};

}  // namespace echomap::source_search
