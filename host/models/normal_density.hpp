// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <numbers>

namespace echomap::models {

/// Density of a normal distribution with that standard deviation, so far off its mean.
inline double normal_density(double deviation, double stddev) {
  const double ratio = deviation / stddev;
  return std::exp(-0.5 * ratio * ratio) / (stddev * std::sqrt(2.0 * std::numbers::pi));
}

}  // namespace echomap::models
