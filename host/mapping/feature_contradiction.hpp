// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "host/mapping/bearing_profile.hpp"
#include "host/mapping/echo_feature.hpp"
#include "host/mapping/feature_support.hpp"
#include "host/mapping/sonar_surfaces.hpp"

namespace echomap::mapping {

/// What stops have heard, as evidence against features. A post or round thing answers from all
/// around, and a wall wherever the foot of the perpendicular is on it: a stop that listened there
/// and heard only something farther away, or nothing, contradicts the feature. One that heard
/// something nearer says nothing, since the nearest echo comes first.
class FeatureContradiction {
 public:
  /// Takes what the scans that `among` marks have heard, where they are placed now.
  FeatureContradiction(const std::vector<ScanSurfaces>& scans,
                       const std::vector<bool>& among,
                       const SurfaceMatchingParams& params);

  /// How many stops, other than those of the supporters, contradict the feature.
  std::size_t count(const EchoFeature& feature, const std::vector<Sighting>& supporters) const;

 private:
  struct Stop {
    std::size_t scan = 0;
    Eigen::Vector2d center_m = Eigen::Vector2d::Zero();
    BearingProfile heard_m;
  };

  bool contradicts(const Stop& stop, const EchoFeature& feature) const;

  double beyond_m_;
  double max_range_m_;
  std::vector<Stop> stops_;
};

}  // namespace echomap::mapping
