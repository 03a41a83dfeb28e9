// SPDX-License-Identifier: MIT
#include "host/models/range_likelihood.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "host/models/normal_density.hpp"

namespace echomap::models {

BeamModel::BeamModel(const BeamModelParams& params) : params_(params) {
  const double least = std::min({params.short_chance,
                                 params.missed_chance,
                                 params.silent_chance,
                                 params.random_chance,
                                 params.oblique_missed_chance,
                                 params.oblique_silent_chance,
                                 params.unseen_silent_chance,
                                 params.unseen_edge_chance});
  const double always = params.short_chance + params.random_chance;
  const double most =
      always + std::max({params.missed_chance + params.silent_chance,
                         params.oblique_missed_chance + params.oblique_silent_chance,
                         params.unseen_silent_chance + params.unseen_edge_chance});
  const double min_noise_m = std::min(params.hit_stddev_m, params.unseen_edge_stddev_m);
  const double max_noise_m = std::max(params.hit_stddev_m, params.unseen_edge_stddev_m);
  const bool noise_ok = min_noise_m > 0.0 && std::isfinite(max_noise_m);
  const bool range_ok = params.max_range_m > 0.0 && std::isfinite(params.max_range_m);
  if (!(most < 1.0) || !(least >= 0.0) || !noise_ok || !range_ok) {
    throw std::invalid_argument(
        "beam model: chances are not negative and leave some to a hit; noise and range are above "
        "0");
  }
}

double BeamModel::likelihood(std::optional<double> range_m, const ExpectedRange& expected) const {
  const double max_m = params_.max_range_m;
  if (!expected.range_m) {
    // Of the chances only those stand that need no obstacle.
    const double something = params_.short_chance + params_.random_chance;
    return range_m ? something / max_m : 1.0 - something;
  }
  if (expected.is_unseen) {
    return unseen_likelihood(range_m, *expected.range_m);
  }
  const double missed = expected.is_oblique ? params_.oblique_missed_chance : params_.missed_chance;
  const double silent = expected.is_oblique ? params_.oblique_silent_chance : params_.silent_chance;
  if (!range_m) {
    return silent;
  }
  const double hit_chance = 1.0 - params_.short_chance - params_.random_chance - missed - silent;
  const double expected_m = *expected.range_m;
  const double hit = hit_chance * normal_density(*range_m - expected_m, params_.hit_stddev_m);
  const double before_m = std::max(expected_m, params_.hit_stddev_m);
  const double behind_m = std::max(max_m - expected_m, params_.hit_stddev_m);
  const double aside = *range_m < expected_m ? params_.short_chance / before_m : missed / behind_m;
  return hit + aside + params_.random_chance / max_m;
}

double BeamModel::unseen_likelihood(std::optional<double> range_m, double edge_m) const {
  if (!range_m) {
    return params_.unseen_silent_chance;
  }
  const double beyond_chance = 1.0 - params_.short_chance - params_.random_chance -
                               params_.unseen_silent_chance - params_.unseen_edge_chance;
  const double stddev_m = params_.unseen_edge_stddev_m;
  const double beyond_m = params_.max_range_m - edge_m;
  const double possible = 0.5 * (std::erf(edge_m / stddev_m / std::numbers::sqrt2) +
                                 std::erf(beyond_m / stddev_m / std::numbers::sqrt2));
  const double at_edge =
      params_.unseen_edge_chance * normal_density(*range_m - edge_m, stddev_m) / possible;
  const double aside = *range_m < edge_m ? params_.short_chance / edge_m : beyond_chance / beyond_m;
  return at_edge + aside + params_.random_chance / params_.max_range_m;
}

BeamModelParams sonar_cone_returns() {
  return {.hit_stddev_m = 0.08,
          .short_chance = 0.03,
          .missed_chance = 0.06,
          .silent_chance = 0.06,
          .random_chance = 0.03,
          .oblique_missed_chance = 0.25,
          .oblique_silent_chance = 0.25,
          .unseen_silent_chance = 0.37,
          .unseen_edge_chance = 0.35,
          .unseen_edge_stddev_m = 0.15,
          .max_range_m = 4.0};
}

BeamModelParams sonar_cone_returns_in_own_map() {
  BeamModelParams params = sonar_cone_returns();
  params.silent_chance = 0.12;
  params.oblique_silent_chance = 0.4;
  return params;
}

BeamModelParams laser_returns() {
  return {.hit_stddev_m = 0.1,
          .short_chance = 0.1,
          .missed_chance = 0.02,
          .silent_chance = 0.02,
          .random_chance = 0.05,
          .oblique_missed_chance = 0.02,
          .oblique_silent_chance = 0.02,
          .unseen_silent_chance = 0.2,
          .unseen_edge_chance = 0.35,
          .unseen_edge_stddev_m = 0.15,
          .max_range_m = 8.0};
}

}  // namespace echomap::models
