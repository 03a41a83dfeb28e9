// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "host/mapping/placed_reading.hpp"
#include "host/mapping/sonar_feature.hpp"

namespace echomap::mapping {

/// What a vote is and how many make a feature.
struct ArcVotingParams {
  /// Half the opening angle of the beam: 13 to 16 degrees for HC-SR04 and NXT (robot profile).
  double beam_half_angle_rad = 0.2269;
  /// Cells of the tables: bearing of a wall's normal, its distance, and the side of a post's
  /// square. Tardos et al. have 5 degrees and 10 cm; a room is smaller than their corridors.
  double bearing_step_rad = 0.0436;
  double distance_step_m = 0.04;
  /// A return belongs to a feature whose range is off by at most this: 2 sigma of the returns.
  double range_tolerance_m = 0.06;
  /// For the fit: of a return, and of its bearing within the beam.
  double range_sd_m = 0.03;
  double bearing_sd_rad = 0.13;
  /// Returns, and places that they were heard from, that a feature needs. From one place a wall and
  /// a post sound alike.
  std::size_t least_votes = 10;
  std::size_t least_places = 3;
};

/// A wall or post and the returns that came from it.
struct VotedFeature {
  SonarFeature feature;
  /// Of the fitted parameters.
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
  /// Indices of the readings; each belongs to one feature at most.
  std::vector<std::size_t> supporters;
};

/// Finds straight walls and posts or corners in returns from many places by a Hough transform
/// (Tardos et al. 2002, section 3): a return says that a wall touches its arc, or that a post
/// stands on it, and votes for every cell along it; the cell with the most votes is fitted to its
/// returns by least squares and takes them, and again. The best supported comes first. Throws
/// std::invalid_argument for parameters that are not above zero.
std::vector<VotedFeature> vote_for_features(const std::vector<PlacedReading>& readings,
                                            const ArcVotingParams& params = {});

}  // namespace echomap::mapping
