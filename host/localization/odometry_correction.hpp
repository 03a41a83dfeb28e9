// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>

namespace echomap::localization {

/// A distance by the odometry and by a tape measure.
struct MeasuredDistance {
  double odometry_m = 0.0;
  double true_m = 0.0;
};

/// The straight line true = slope * odometry + offset. Mukherjee et al., section IV.A, call the
/// slope a and the offset b, but their equation (4), named a, is the offset and their equation (5),
/// named b, the slope.
struct DistanceCorrection {
  double slope = 1.0;
  double offset_m = 0.0;

  /// Backwards it is the same the other way round; a robot that stands has not moved by the offset.
  double corrected_m(double odometry_m) const;
};

/// By least squares; empty for fewer than two different distances, and for one that is not finite.
std::optional<DistanceCorrection> fit_correction(std::span<const MeasuredDistance> distances);

}  // namespace echomap::localization
