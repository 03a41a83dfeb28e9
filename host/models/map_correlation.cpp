// SPDX-License-Identifier: MIT
#include "host/models/map_correlation.hpp"

#include <algorithm>
#include <cmath>

#include "host/geometry/parameter_validator.hpp"

namespace echomap::models {

namespace {

/// Sums of squares below this are rounding.
constexpr double kNoContrast = 1e-12;

}  // namespace

double MapCorrelation::value() const {
  if (cells_ == 0.0) {
    return 1.0;
  }
  const double mean = both_ / (2.0 * cells_);  // Equation 6.35.
  const double local = both_ - map_;
  const double map_spread = map_squares_ - 2.0 * mean * map_ + cells_ * mean * mean;
  const double local_spread = local_squares_ - 2.0 * mean * local + cells_ * mean * mean;
  if (map_spread < kNoContrast && local_spread < kNoContrast) {
    return 1.0;
  }
  if (map_spread < kNoContrast || local_spread < kNoContrast) {
    return 0.0;
  }
  // Sum of (map - mean)(local - mean), as map and local add up to 2 cells mean.
  const double together = products_ - cells_ * mean * mean;
  return together / std::sqrt(map_spread * local_spread);  // Equation 6.36.
}

CorrelationLikelihood::CorrelationLikelihood(const CorrelationParams& params) : params_(params) {
  geometry::ParameterValidator("correlation")
      .positive("least", params.least)
      .at_most("least", params.least, 1.0);
}

double CorrelationLikelihood::likelihood(const MapCorrelation& correlation) const {
  return std::max(correlation.value(), params_.least);  // Equation 6.37.
}

}  // namespace echomap::models
