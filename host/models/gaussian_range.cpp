// SPDX-License-Identifier: MIT
#include "host/models/gaussian_range.hpp"

#include <cmath>
#include <numbers>

#include "host/geometry/parameter_validator.hpp"

namespace echomap::models {

GaussianRange::GaussianRange(const GaussianRangeParams& params) : params_(params) {
  geometry::ParameterValidator("gaussian range")
      .positive_finite("sense_stddev_m", params.sense_stddev_m)
      .positive_finite("max_range_m", params.max_range_m);
}

double GaussianRange::likelihood(std::optional<double> range_m,
                                 const ExpectedRange& expected) const {
  if (!range_m) {
    return 1.0;
  }
  const double off_m = *range_m - expected.range_m.value_or(params_.max_range_m);
  const double variance_m2 = params_.sense_stddev_m * params_.sense_stddev_m;
  return std::exp(-off_m * off_m / (2.0 * variance_m2)) /  // Equation (1).
         std::sqrt(2.0 * std::numbers::pi * variance_m2);
}

}  // namespace echomap::models
