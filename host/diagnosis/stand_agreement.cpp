// SPDX-License-Identifier: MIT
#include "host/diagnosis/stand_agreement.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "host/diagnosis/placed_log.hpp"
#include "host/geometry/square.hpp"
#include "host/geometry/unit_vector.hpp"

namespace echomap::diagnosis {
namespace {

constexpr double kNothingInCommon = std::numeric_limits<double>::infinity();

/// Variances of what was heard from two places.
struct Tolerance {
  Tolerance(const StandAgreementParams& params, double travelled_m)
      : bearing(geometry::square(params.bearing_stddev_rad) +
                geometry::square(params.bearing_drift_rad_per_sqrt_m) * travelled_m),
        depth(geometry::square(params.depth_stddev_m) +
              geometry::square(params.drift_m_per_m * travelled_m)),
        point(geometry::square(params.point_stddev_m) +
              geometry::square(params.drift_m_per_m * travelled_m)),
        max_apart(geometry::square(params.max_apart_m)),
        ping(geometry::square(params.ping_stddev_m)),
        min_ping_cosine(params.min_ping_cosine) {}

  double bearing;
  double depth;
  double point;
  double max_apart;
  double ping;
  double min_ping_cosine;
};

/// Squared deviations in terms of their variances.
double disagreement(const PlacedSurface& one,
                    const PlacedSurface& other,
                    const Tolerance& tolerance) {
  const Eigen::Vector2d apart_m = one.foot_m - other.foot_m;
  if (!one.is_wall || !other.is_wall) {
    return apart_m.squaredNorm() / tolerance.point;
  }
  if (one.direction.dot(other.direction) <= 0.0 || apart_m.squaredNorm() > tolerance.max_apart) {
    return kNothingInCommon;
  }
  const double sine = geometry::perpendicular(one.direction).dot(other.direction);
  return geometry::square(sine) / tolerance.bearing +
         0.5 *
             (geometry::square(apart_m.dot(one.direction)) +
              geometry::square(apart_m.dot(other.direction))) /
             tolerance.depth;
}

/// The same of a ping: a wide beam hears a wall at its depth, wherever in it the wall's foot lies.
double disagreement(const PlacedPing& ping,
                    const PlacedSurface& surface,
                    const Tolerance& tolerance) {
  const Eigen::Vector2d offset_m = surface.foot_m - ping.at_m;
  const double range_m = surface.is_wall ? offset_m.dot(surface.direction) : offset_m.norm();
  const double cosine = surface.is_wall ? ping.direction.dot(surface.direction)
                                        : ping.direction.dot(offset_m) / range_m;
  const bool is_far =
      surface.is_wall && offset_m.squaredNorm() - geometry::square(range_m) > tolerance.max_apart;
  if (range_m <= 0.0 || cosine < tolerance.min_ping_cosine || is_far) {
    return kNothingInCommon;
  }
  return geometry::square(ping.range_m - range_m) /
         (tolerance.ping + (surface.is_wall ? tolerance.depth : tolerance.point));
}

/// Student's density with four degrees of freedom, but for its constant: what deviates far deviates
/// for another reason.
double density(double squared_deviation) {
  const double base = 1.0 + 0.25 * squared_deviation;
  return 1.0 / (base * base * base);
}

/// Of each surface of that stand, with the best of those before on the same piece of the way.
std::vector<double> least_disagreements(const std::vector<PlacedStand>& stands,
                                        std::size_t stand,
                                        const StandAgreementParams& params) {
  const PlacedStand& here = stands[stand];
  std::vector<double> least(here.surfaces.size(), kNothingInCommon);
  for (std::size_t before = stand; before-- > 0 && stands[before].piece == here.piece;) {
    const Tolerance tolerance(params, here.travelled_m - stands[before].travelled_m);
    for (const PlacedSurface& other : stands[before].surfaces) {
      for (std::size_t i = 0; i < least.size(); ++i) {
        least[i] = std::min(least[i], disagreement(here.surfaces[i], other, tolerance));
      }
    }
  }
  return least;
}

/// With the best surface of all stands around it on the same piece of the way.
double least_disagreement(const PlacedPing& ping,
                          const std::vector<PlacedStand>& stands,
                          const StandAgreementParams& params) {
  double least = kNothingInCommon;
  for (const PlacedStand& stand : stands) {
    const double travelled_m = std::abs(stand.travelled_m - ping.travelled_m);
    if (stand.piece != ping.piece || travelled_m > params.max_ping_travel_m) {
      continue;
    }
    const Tolerance tolerance(params, travelled_m);
    for (const PlacedSurface& surface : stand.surfaces) {
      least = std::min(least, disagreement(ping, surface, tolerance));
    }
  }
  return least;
}

}  // namespace

double log_agreement(const StandLog& log,
                     const RobotErrors& errors,
                     const StandAgreementParams& params) {
  const PlacedLog placed = place(log, errors);
  const auto log_ratio = [&](double squared_deviation) {
    return std::log1p(params.weight * density(squared_deviation));
  };
  double sum = 0.0;
  for (std::size_t stand = 1; stand < placed.stands.size(); ++stand) {
    const auto least = least_disagreements(placed.stands, stand, params);
    for (std::size_t i = 0; i < least.size(); ++i) {
      const auto readings = static_cast<double>(placed.stands[stand].surfaces[i].readings);
      sum += std::min(1.0, readings / params.full_readings) * log_ratio(least[i]);
    }
  }
  for (const PlacedPing& ping : placed.pings) {
    sum += params.ping_weight * log_ratio(least_disagreement(ping, placed.stands, params));
  }
  return sum;
}

}  // namespace echomap::diagnosis
