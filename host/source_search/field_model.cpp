// SPDX-License-Identifier: MIT
#include "host/source_search/field_model.hpp"

#include <cmath>

#include "host/geometry/parameter_validator.hpp"
#include "host/geometry/square.hpp"

namespace echomap::source_search {

using geometry::square;

void validate(const FieldParams& params) {
  const geometry::ParameterValidator validator("source field");
  validator.positive_finite("standoff_m", params.standoff_m)
      .positive_finite("min_strength", params.min_strength)
      .finite("max_strength", params.max_strength)
      .above("max_strength", params.max_strength, params.min_strength)
      .positive_finite("min_background", params.min_background)
      .finite("max_background", params.max_background)
      .above("max_background", params.max_background, params.min_background)
      .positive_finite("level_stddev", params.level_stddev)
      .nonnegative_finite("rate_error", params.rate_error)
      .nonnegative_finite("shield_error", params.shield_error)
      .nonnegative_finite("background_error", params.background_error)
      .require(!params.attenuations_per_m.empty(), "attenuations_per_m has no value");
  for (const double attenuation_per_m : params.attenuations_per_m) {
    validator.nonnegative_finite("attenuations_per_m", attenuation_per_m);
  }
}

double response(double distance_m,
                double solid_m,
                double attenuation_per_m,
                const FieldParams& params) {
  return std::exp(-attenuation_per_m * solid_m) / (square(distance_m) + square(params.standoff_m));
}

double response_variance(double distance_m,
                         double solid_m,
                         double attenuation_per_m,
                         double position_variance_m2,
                         const FieldParams& params) {
  const double distance_m2 = square(distance_m);
  const double by_place = 4.0 * position_variance_m2 * (distance_m2 + position_variance_m2) /
                          square(distance_m2 + square(params.standoff_m));
  return square(params.rate_error) + by_place +
         square(params.shield_error * attenuation_per_m * solid_m);
}

}  // namespace echomap::source_search
