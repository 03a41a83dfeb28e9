// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "host/slam/ekf_slam_filter.hpp"
#include "host/slam/landmark_sighting.hpp"

namespace echomap::slam {

/// When a sighting is taken for one of a landmark; ours.
struct AssociationParams {
  /// Squared Mahalanobis distance up to which a sighting may be of a landmark: 99 % of chi square
  /// with two degrees of freedom. The same share holds for all sightings of a scan together.
  double gate = 9.21;
  /// What is farther than this from all landmarks is a new one. What lies between is nothing.
  double gate_of_new = 30.0;
  /// A wall goes on where a piece of it is seen no farther than this from what is known of it.
  double max_wall_gap_m = 1.0;
  /// The search for the best pairing of a scan gives up after as many steps, with the best so far.
  std::size_t max_steps = 20000;
};

/// A sighting that may be of a landmark.
struct Candidate {
  std::size_t sighting = 0;
  std::size_t landmark = 0;
  LinearSighting linear;
  double squared_distance = 0.0;
  /// Less is likelier: the distance plus the logarithm of its covariance's determinant, so that a
  /// landmark of which little is known does not catch what is of another.
  double unlikeliness = 0.0;
};

/// All pairs of a sighting and a landmark that could be, in the order of the sightings: those of
/// the same kind and label within `gate`, walls where their pieces overlap.
std::vector<Candidate> find_candidates(const EkfSlamFilter& filter,
                                       std::span<const LandmarkSighting> sightings,
                                       double gate,
                                       double max_wall_gap_m);

/// The likeliest pair first, then the likeliest of those with neither of the two, and so on.
std::vector<Candidate> nearest_neighbours(std::vector<Candidate> candidates);

/// Those of the sightings that are of no landmark, by candidates within the wide gate.
std::vector<std::size_t> new_sightings(std::size_t sightings,
                                       std::span<const Candidate> candidates);

}  // namespace echomap::slam
