// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "host/mapping/echo_feature.hpp"
#include "host/mapping/feature_support.hpp"

namespace echomap::mapping {

/// The cheap part of the gate of many sightings: those whose range fits a feature, found without a
/// root or a bearing. What it lets pass is left to FeatureGauge.
class RangeGate {
 public:
  /// `tolerance_m` is that of the ranges.
  RangeGate(const std::vector<Sighting>& sightings, double tolerance_m);

  /// A sighting that passes no more.
  void close(std::size_t sighting);

  /// Indices of all sightings within the tolerance, in their order; by rounding one that is not may
  /// be among them. Holds until the next call.
  const std::vector<std::size_t>& passing(const EchoFeature& feature);

 private:
  void measure_wall(const EchoFeature& wall);
  void measure_round(const EchoFeature& round);

  double tolerance_m_;
  std::vector<double> x_m_;
  std::vector<double> y_m_;
  std::vector<double> range_m_;
  /// Of the last feature: by how much each sighting is beyond the tolerance, in metres for a wall
  /// and in square metres for anything round.
  std::vector<double> beyond_;
  std::vector<std::size_t> passing_;
};

}  // namespace echomap::mapping
