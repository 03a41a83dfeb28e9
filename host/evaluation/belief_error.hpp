// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "host/evaluation/trajectory_error.hpp"
#include "host/pipeline/team_replay.hpp"

namespace echomap::evaluation {

/// How far a robot's beliefs are off the truth, and whether they say so. Nothing is aligned: both
/// are in the same map.
struct BeliefError {
  std::size_t poses = 0;  ///< At which the truth is known.
  double rmse_m = 0.0;
  double heading_rmse_rad = 0.0;
  /// Root of the mean of what the covariances expect of the position's squared error.
  double expected_rmse_m = 0.0;
  /// Mean normalized estimation error squared of x, y and heading: 3 for a consistent filter.
  double nees = 0.0;
  /// Share of the positions within the ellipse that is to hold 95 % of them.
  double within_95 = 0.0;
};

/// Compares beliefs and truth, both in the order of their stamps; the truth is interpolated between
/// poses that are no more than half a second apart. Where no belief has a truth, `poses` is 0.
BeliefError score_beliefs(const std::vector<pipeline::StampedBelief>& beliefs,
                          const std::vector<TruePose>& truth);

}  // namespace echomap::evaluation
