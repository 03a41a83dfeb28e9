// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "host/geometry/pose2.hpp"
#include "host/localization/particles.hpp"
#include "host/localization/workers.hpp"

namespace echomap::localization {

/// One place where the robot may be.
struct PoseHypothesis {
  geometry::Pose2 T_map_robot;
  /// Of x, y (m) and heading (rad).
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  double probability = 0.0;
};

/// How finely particles are told apart.
struct HypothesisParams {
  double bin_m = 0.25;
  double bin_rad = 0.2618;  ///< 15 degrees; a whole number of them goes into a turn.
};

/// The hills of the particles' weight, the heaviest first: particles are put into bins of position
/// and heading, each bin leads to its heaviest neighbour, and bins that lead to one summit are one
/// hypothesis. The effort grows with the number of particles. `weights` are not negative; without
/// any above 0 there is no hypothesis.
std::vector<PoseHypothesis> find_hypotheses(const Particles& particles,
                                            std::span<const float> weights,
                                            const HypothesisParams& params = {},
                                            const Workers& workers = Workers());

}  // namespace echomap::localization
