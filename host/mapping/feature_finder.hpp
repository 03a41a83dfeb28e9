// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <queue>
#include <utility>
#include <vector>

#include "host/mapping/echo_feature.hpp"
#include "host/mapping/feature_contradiction.hpp"
#include "host/mapping/feature_support.hpp"
#include "host/mapping/range_gate.hpp"

namespace echomap::mapping {

/// A feature and the sightings that support it, at most one of each scan.
struct SupportedFeature {
  EchoFeature feature;
  std::vector<Sighting> supporters;
};

/// Finds features in sightings, the best supported first: each pair of sightings proposes walls,
/// posts and round things, the one that most sightings support takes them, and again (in the manner
/// of Tardos et al. 2002).
class FeatureFinder {
 public:
  /// `sightings` are in the order of their scans. `params` outlives this.
  FeatureFinder(std::vector<Sighting> sightings,
                FeatureContradiction contradiction,
                const SurfaceMatchingParams& params);

  /// The proposal with the most support, fitted; its supporters support nothing else from then on.
  /// Empty where none has enough.
  std::optional<SupportedFeature> take_best();

 private:
  struct Proposal {
    EchoFeature feature;
    std::vector<std::size_t> supporters;  ///< Indices of the sightings.
    double support = 0.0;
  };

  void propose(const Sighting& first, const Sighting& second);
  void add_proposal(const EchoFeature& feature, const Sighting& first, const Sighting& second);
  /// Collects, of each scan, the sighting that fits best.
  void gather(Proposal& proposal);
  double penalty(const Proposal& proposal) const;
  std::vector<Sighting> sightings_of(const Proposal& proposal) const;
  SupportedFeature take(Proposal proposal);

  std::vector<Sighting> sightings_;
  RangeGate gate_;  ///< Closed to sightings that support a feature.
  FeatureContradiction contradiction_;
  const SurfaceMatchingParams& params_;
  std::vector<Proposal> proposals_;
  std::priority_queue<std::pair<double, std::size_t>> queue_;
};

}  // namespace echomap::mapping
