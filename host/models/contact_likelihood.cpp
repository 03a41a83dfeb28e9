// SPDX-License-Identifier: MIT
#include "host/models/contact_likelihood.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace echomap::models {

namespace {

/// Of a standard normal number below `value`.
double chance_below(double value) { return 0.5 * std::erfc(-value / std::numbers::sqrt2); }

}  // namespace

ContactLikelihood::ContactLikelihood(const ContactParams& params) : params_(params) {
  const bool noise_ok = params.contact_std_m > 0.0 && params.light_std_m > 0.0;
  const bool chance_ok = params.wrong_chance > 0.0 && params.wrong_chance < 1.0;
  if (!noise_ok || !chance_ok || !(params.light_reach_m >= 0.0) || !(params.overlap_rad >= 0.0)) {
    throw std::invalid_argument(
        "contacts: deviations are above 0, a chance within (0, 1), reach and overlap not negative");
  }
}

double ContactLikelihood::likelihood(const ContactReading& reading, const WallAhead& wall) const {
  const auto mixed = [&](double right) {
    return params_.wrong_chance + (1.0 - params_.wrong_chance) * right;
  };
  return mixed(of_bumper(reading, wall)) * mixed(of_light(reading.virtual_wall, wall.ahead_m));
}

double ContactLikelihood::of_bumper(const ContactReading& reading, const WallAhead& wall) const {
  const double off = wall.gap_m / params_.contact_std_m;
  if (!reading.bump_left && !reading.bump_right) {
    return chance_below(off + 2.0);
  }
  const bool may_be_left = wall.bearing_rad > -params_.overlap_rad;
  const bool may_be_right = wall.bearing_rad < params_.overlap_rad;
  const bool fits = (!reading.bump_left || may_be_left) && (!reading.bump_right || may_be_right);
  return fits ? std::exp(-0.5 * off * off) : 0.0;
}

double ContactLikelihood::of_light(bool is_seen, double ahead_m) const {
  const double seen = chance_below((params_.light_reach_m - ahead_m) / params_.light_std_m);
  return is_seen ? seen : 1.0 - seen;
}

}  // namespace echomap::models
