// SPDX-License-Identifier: MIT
#include "host/models/infrared_range.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "host/models/normal_density.hpp"

namespace echomap::models {

InfraredRange::InfraredRange(const InfraredRangeParams& params) : params_(params) {
  const double least =
      std::min({params.silent_chance, params.aslant_silent_chance, params.random_chance});
  const double most =
      params.random_chance + std::max(params.silent_chance, params.aslant_silent_chance);
  const bool noise_ok = params.near_std_m > 0.0 && params.far_std_m >= 0.0;
  if (!(least >= 0.0) || !(most < 1.0) || !noise_ok || !(params.max_range_m > 0.0)) {
    throw std::invalid_argument(
        "infra-red range: chances are not negative and leave some to a hit; noise and range are "
        "above 0");
  }
}

double InfraredRange::likelihood(std::optional<double> range_m,
                                 const ExpectedRange& expected) const {
  const double most_m = params_.max_range_m;
  const double anywhere = params_.random_chance / most_m;
  if (!expected.range_m) {
    return range_m ? anywhere : 1.0 - params_.random_chance;
  }
  const double silent = expected.is_aslant ? params_.aslant_silent_chance : params_.silent_chance;
  if (!range_m) {
    return silent;
  }
  const double hit = 1.0 - silent - params_.random_chance;
  if (expected.is_aslant) {
    const double least_m = std::max(0.0, std::min(*expected.range_m, most_m) - params_.near_std_m);
    return anywhere + (*range_m > least_m ? hit / (most_m - least_m) : 0.0);
  }
  const double std_m =
      params_.near_std_m + params_.far_std_m * std::pow(*expected.range_m / most_m, 3);
  return anywhere + hit * normal_density(*range_m - *expected.range_m, std_m);
}

}  // namespace echomap::models
