// SPDX-License-Identifier: MIT
#include "host/models/contact_likelihood.hpp"

#include <cmath>
#include <numbers>

#include "host/geometry/parameter_validator.hpp"

namespace echomap::models {

namespace {

/// Of a standard normal number below `value`.
double chance_below(double value) { return 0.5 * std::erfc(-value / std::numbers::sqrt2); }

}  // namespace

ContactLikelihood::ContactLikelihood(const ContactParams& params) : params_(params) {
  geometry::ParameterValidator("contacts")
      .positive("contact_stddev_m", params.contact_stddev_m)
      .positive("light_stddev_m", params.light_stddev_m)
      .positive("wrong_chance", params.wrong_chance)
      .below("wrong_chance", params.wrong_chance, 1.0)
      .at_least("light_reach_m", params.light_reach_m, 0.0)
      .at_least("overlap_rad", params.overlap_rad, 0.0);
}

double ContactLikelihood::likelihood(const ContactReading& reading, const WallAhead& wall) const {
  const auto mixed = [&](double right) {
    return params_.wrong_chance + (1.0 - params_.wrong_chance) * right;
  };
  return mixed(of_bumper(reading, wall)) * mixed(of_light(reading.virtual_wall, wall.ahead_m));
}

double ContactLikelihood::of_bumper(const ContactReading& reading, const WallAhead& wall) const {
  const double off = wall.gap_m / params_.contact_stddev_m;
  if (!reading.bump_left && !reading.bump_right) {
    return chance_below(off + 2.0);
  }
  const bool may_be_left = wall.bearing_rad > -params_.overlap_rad;
  const bool may_be_right = wall.bearing_rad < params_.overlap_rad;
  const bool fits = (!reading.bump_left || may_be_left) && (!reading.bump_right || may_be_right);
  return fits ? std::exp(-0.5 * off * off) : 0.0;
}

double ContactLikelihood::of_light(bool is_seen, double ahead_m) const {
  const double seen = chance_below((params_.light_reach_m - ahead_m) / params_.light_stddev_m);
  return is_seen ? seen : 1.0 - seen;
}

}  // namespace echomap::models
