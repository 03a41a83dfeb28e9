// SPDX-License-Identifier: MIT
#include "host/models/infrared_range.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "host/models/normal_density.hpp"

namespace echomap::models {

InfraredRange::InfraredRange(const InfraredRangeParams& params) : params_(params) {
  const double least =
      std::min({params.silent_chance, params.oblique_silent_chance, params.random_chance});
  const double most =
      params.random_chance + std::max(params.silent_chance, params.oblique_silent_chance);
  const bool noise_ok = params.near_stddev_m > 0.0 && params.far_stddev_m >= 0.0;
  if (!(least >= 0.0) || !(most < 1.0) || !noise_ok || !(params.max_range_m > 0.0)) {
    throw std::invalid_argument(
        "infra-red range: chances are not negative and leave some to a hit; noise and range are "
        "above 0");
  }
}

double InfraredRange::likelihood(std::optional<double> range_m,
                                 const ExpectedRange& expected) const {
  const double max_m = params_.max_range_m;
  const double anywhere = params_.random_chance / max_m;
  if (!expected.range_m) {
    return range_m ? anywhere : 1.0 - params_.random_chance;
  }
  const double silent = expected.is_oblique ? params_.oblique_silent_chance : params_.silent_chance;
  if (!range_m) {
    return silent;
  }
  const double hit = 1.0 - silent - params_.random_chance;
  if (expected.is_oblique) {
    const double min_m = std::max(0.0, std::min(*expected.range_m, max_m) - params_.near_stddev_m);
    return anywhere + (*range_m > min_m ? hit / (max_m - min_m) : 0.0);
  }
  const double stddev_m =
      params_.near_stddev_m + params_.far_stddev_m * std::pow(*expected.range_m / max_m, 3);
  return anywhere + hit * normal_density(*range_m - *expected.range_m, stddev_m);
}

}  // namespace echomap::models
