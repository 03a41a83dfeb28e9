// SPDX-License-Identifier: MIT
#include "host/mapping/region_bearing.hpp"

#include <algorithm>
#include <cmath>

#include "host/geometry/angle.hpp"
#include "host/sensors/range_scan.hpp"

namespace echomap::mapping {

namespace {

/// Looks farther off than this tell of other surfaces.
constexpr double kAroundRad = geometry::radians(45.0);
/// Bearings that are tried to either side, besides the middle one.
constexpr int kBearings = 8;
/// Angles up to which a surface may be heard: a post not quite as far as the beam goes, a smooth
/// wall as far as beam and incidence go together.
constexpr double kNarrowestRad = geometry::radians(10.0);
constexpr double kMaxRad = geometry::radians(34.0);
constexpr double kWidthStepRad = geometry::radians(3.0);
/// The chance to be heard falls from 73 to 27 % over twice this angle.
constexpr double kEdgeRad = geometry::radians(4.0);
/// The chance of an echo from there without the surface, and of none with it.
constexpr double kMishap = 0.01;
constexpr double kDropOut = 0.03;

/// What a look around says.
struct Heard {
  double off_rad = 0.0;
  bool is_heard = false;
};

std::vector<Heard> heard_around(const std::vector<sensors::Beam>& looks,
                                double bearing_rad,
                                double range_m,
                                const SonarSurfaceParams& params) {
  std::vector<Heard> heard;
  for (const sensors::Beam& look : looks) {
    const double off_rad = std::abs(geometry::angle_between(bearing_rad, look.bearing_rad));
    if (off_rad > kAroundRad) {
      continue;
    }
    const double beyond_m = look.range_m
                                ? *look.range_m - range_off_foot_m(range_m, off_rad, params)
                                : params.depth_tolerance_m + 1.0;
    if (beyond_m >= -params.depth_tolerance_m) {
      heard.push_back({off_rad, beyond_m <= params.depth_tolerance_m});
    }
  }
  return heard;
}

double log_likelihood(const std::vector<Heard>& heard, double width_rad) {
  double sum = 0.0;
  for (const Heard& look : heard) {
    const double in_beam = 1.0 / (1.0 + std::exp((look.off_rad - width_rad) / kEdgeRad));
    const double chance = kMishap + (1.0 - kMishap - kDropOut) * in_beam;
    sum += std::log(look.is_heard ? chance : 1.0 - chance);
  }
  return sum;
}

}  // namespace

double range_off_foot_m(double foot_m, double off_rad, const SonarSurfaceParams& params) {
  return foot_m / std::cos(std::max(0.0, off_rad - params.beam_half_angle_rad));
}

double likely_bearing_rad(const std::vector<sensors::Beam>& looks,
                          double near_rad,
                          double within_rad,
                          double range_m,
                          const SonarSurfaceParams& params) {
  double most = -1e9;
  double weights = 0.0;
  double sum_rad = 0.0;
  for (int i = -kBearings; i <= kBearings; ++i) {
    const double aside_rad = within_rad * i / kBearings;
    const auto heard = heard_around(looks, near_rad + aside_rad, range_m, params);
    // NOLINTNEXTLINE(clang-analyzer-security.FloatLoopCounter): the last step may be missing
    for (double width_rad = kNarrowestRad; width_rad <= kMaxRad; width_rad += kWidthStepRad) {
      const double likelihood = log_likelihood(heard, width_rad);
      if (likelihood > most) {
        const double less = std::exp(most - likelihood);
        weights *= less;
        sum_rad *= less;
        most = likelihood;
      }
      const double weight = std::exp(likelihood - most);
      weights += weight;
      sum_rad += weight * aside_rad;
    }
  }
  return geometry::wrap_angle(near_rad + sum_rad / weights);
}

}  // namespace echomap::mapping
