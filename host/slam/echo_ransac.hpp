// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <random>
#include <vector>

#include <Eigen/Core>

#include "host/mapping/echo_feature.hpp"

namespace echomap::slam {

/// How walls and points are looked for among echoes; ours, for one sonar that pans while the robot
/// stands or drives.
struct EchoRansacParams {
  /// Pairs of echoes that are drawn. Their ends lie no farther apart than the reach.
  std::size_t pairs = 400;
  double pair_reach_m = 1.0;
  mapping::HearingParams hearing{};
  double range_stddev_m =
      0.03;  ///< Mean precision of an HC-SR04 (Singh and Bedi 2013, section 2.4).
  /// A wall's echoes leave no wider gap along it.
  double max_gap_m = 0.8;
  /// So many echoes make a feature. A cone hears a wall from twice as many directions as a point.
  std::size_t min_wall_echoes = 8;
  std::size_t min_point_echoes = 4;
  /// What is less well known is not told.
  double max_normal_stddev_rad = 0.1;
  double max_point_stddev_m = 0.08;
};

/// Throws std::invalid_argument for invalid parameters.
void validate(const EchoRansacParams& params);

/// A feature and the echoes that came from it.
struct HeardFeature {
  mapping::EchoFeature feature;
  /// Of its value, as far as the echoes' noise goes.
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
  /// Indices; each echo is of one feature at most.
  std::vector<std::size_t> echoes;
};

/// Random sample consensus (Fischler and Bolles 1981) over the echoes of cones: pairs of them are
/// drawn, each says where walls and points may be, and what the most echoes agree with, less those
/// that should have heard it and heard something behind it, is fitted to them and takes them; and
/// again. The best supported comes first. The fit is least squares of ranges and of bearings, which
/// lie anywhere in the cone (Tardos et al. 2002, section 3).
std::vector<HeardFeature> find_features(const std::vector<mapping::Echo>& echoes,
                                        const EchoRansacParams& params,
                                        std::mt19937& random);

}  // namespace echomap::slam
