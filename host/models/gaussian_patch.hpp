// SPDX-License-Identifier: MIT
#pragma once

#include "host/geometry/segment.hpp"
#include "host/models/sensor_reading.hpp"

namespace echomap::models {

/// Hennessey et al. The paper says that a Gaussian kernel is added, not how wide.
struct GaussianPatchParams {
  /// Standard deviation of the kernel: one of their cells.
  double sigma_m = 0.05;
  /// The kernel ends here: five by five of their cells.
  double radius_m = 0.125;
};

/// Inverse model of Hennessey et al., section II.B: each echo adds a patch of confidence, 1 where
/// the echo would lie on the axis and less around it,
///
///     exp(-d^2 / (2 sigma^2)),
///
/// and nothing is ever taken away. `evidence` is that confidence; a cell of a new map has 0, which
/// is "empty", so this map knows no unknown.
class GaussianPatch {
 public:
  /// Throws std::invalid_argument for invalid parameters.
  explicit GaussianPatch(const GaussianPatchParams& params = {});

  double evidence(const SensorReading& reading, const PolarPoint& point) const;
  double reach_m(const SensorReading& reading) const;

 private:
  GaussianPatchParams params_;
};

/// Where a bumper of `width_m`, `ahead_m` in front of the robot's centre, has met something; in the
/// robot's frame.
geometry::Segment bumper_line(double ahead_m, double width_m);

}  // namespace echomap::models
