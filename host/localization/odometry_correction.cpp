// SPDX-License-Identifier: MIT
#include "host/localization/odometry_correction.hpp"

#include <cmath>

namespace echomap::localization {

double DistanceCorrection::corrected_m(double odometry_m) const {
  if (odometry_m == 0.0) {
    return 0.0;
  }
  return slope * odometry_m + (odometry_m > 0.0 ? offset_m : -offset_m);
}

std::optional<DistanceCorrection> fit_correction(std::span<const MeasuredDistance> distances) {
  if (distances.empty()) {
    return std::nullopt;
  }
  const auto count = static_cast<double>(distances.size());
  MeasuredDistance mean;
  for (const MeasuredDistance& distance : distances) {
    mean.odometry_m += distance.odometry_m / count;
    mean.true_m += distance.true_m / count;
  }
  // Equations (4) and (5) around the means, where they lose no digits.
  double spread_m2 = 0.0;
  double common_m2 = 0.0;
  for (const MeasuredDistance& distance : distances) {
    const double off_m = distance.odometry_m - mean.odometry_m;
    spread_m2 += off_m * off_m;
    common_m2 += off_m * (distance.true_m - mean.true_m);
  }
  const double slope = common_m2 / spread_m2;
  return std::isfinite(slope)
             ? std::optional(DistanceCorrection{slope, mean.true_m - slope * mean.odometry_m})
             : std::nullopt;
}

}  // namespace echomap::localization
