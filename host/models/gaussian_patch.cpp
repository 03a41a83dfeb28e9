// SPDX-License-Identifier: MIT
#include "host/models/gaussian_patch.hpp"

#include <cmath>

#include "host/geometry/parameter_validator.hpp"
#include "host/models/concepts.hpp"

namespace echomap::models {

static_assert(InverseModel<GaussianPatch>);

GaussianPatch::GaussianPatch(const GaussianPatchParams& params) : params_(params) {
  geometry::ParameterValidator("gaussian patch")
      .positive("sigma_m", params.sigma_m)
      .positive("radius_m", params.radius_m);
}

double GaussianPatch::evidence(const SensorReading& reading, const PolarPoint& point) const {
  if (!reading.range_m) {
    return 0.0;
  }
  const double ahead_m = point.range_m * std::cos(point.off_axis_rad) - *reading.range_m;
  const double aside_m = point.range_m * std::sin(point.off_axis_rad);
  const double away_m = std::hypot(ahead_m, aside_m);
  const double sigmas = away_m / params_.sigma_m;
  return away_m > params_.radius_m ? 0.0 : std::exp(-0.5 * sigmas * sigmas);
}

double GaussianPatch::reach_m(const SensorReading& reading) const {
  return reading.range_m ? *reading.range_m + params_.radius_m : 0.0;
}

geometry::Segment bumper_line(double ahead_m, double width_m) {
  return {{ahead_m, -0.5 * width_m}, {ahead_m, 0.5 * width_m}};
}

}  // namespace echomap::models
