// SPDX-License-Identifier: MIT
#include "host/diagnosis/stand_agreement.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "host/geometry/square.hpp"
#include "host/geometry/unit_vector.hpp"
#include "host/sensors/odometry.hpp"

namespace echomap::diagnosis {
namespace {

constexpr double kNothingInCommon = std::numeric_limits<double>::infinity();

/// A surface where a robot of some errors has heard it.
struct PlacedSurface {
  Eigen::Vector2d foot_m;
  Eigen::Vector2d direction;  ///< From the sonar to it.
  bool is_wall = false;
  double weight = 0.0;
};

struct PlacedStand {
  std::vector<PlacedSurface> surfaces;
  double travelled_m = 0.0;  ///< What the wheels have rolled until then, on average.
  std::size_t piece = 0;
};

/// Variances of what two stands have heard.
struct Tolerance {
  Tolerance(const StandAgreementParams& params, double travelled_m)
      : bearing(geometry::square(params.bearing_stddev_rad) +
                geometry::square(params.bearing_drift_rad_per_sqrt_m) * travelled_m),
        depth(geometry::square(params.depth_stddev_m) +
              geometry::square(params.drift_m_per_m * travelled_m)),
        point(geometry::square(params.point_stddev_m) +
              geometry::square(params.drift_m_per_m * travelled_m)),
        max_apart(geometry::square(params.max_apart_m)) {}

  double bearing;
  double depth;
  double point;
  double max_apart;
};

geometry::Pose2 moved_by(const WheelStep& step, double track_m, const RobotErrors& errors) {
  const double left_m = errors.left_scale * step.left_m;
  const double right_m = errors.right_scale * step.right_m;
  return sensors::arc_step(0.5 * (left_m + right_m),
                           (right_m - left_m) / (errors.track_scale * track_m));
}

std::vector<PlacedSurface> placed(const Stand& stand,
                                  const geometry::Pose2& T_map_axis,
                                  const RobotErrors& errors,
                                  double full_readings) {
  std::vector<PlacedSurface> surfaces;
  surfaces.reserve(stand.surfaces.size());
  for (const mapping::SonarSurface& surface : stand.surfaces) {
    const Eigen::Vector2d direction = geometry::unit_vector(
        T_map_axis.heading_rad() + errors.pan_offset_rad + errors.pan_scale * surface.bearing_rad);
    surfaces.push_back({T_map_axis.position_m() + errors.range_scale * surface.range_m * direction,
                        direction,
                        surface.half_length_m > 0.0,
                        std::min(1.0, static_cast<double>(surface.readings) / full_readings)});
  }
  return surfaces;
}

std::vector<PlacedStand> place_stands(const StandLog& log,
                                      const RobotErrors& errors,
                                      double full_readings) {
  const geometry::Pose2 T_robot_axis(log.robot().sonar_x_m, log.robot().sonar_y_m, 0.0);
  std::vector<PlacedStand> stands;
  stands.reserve(log.stands().size());
  geometry::Pose2 T_map_robot;
  double travelled_m = 0.0;
  std::size_t steps = 0;
  for (const Stand& stand : log.stands()) {
    for (; steps < stand.steps; ++steps) {
      const WheelStep& step = log.steps()[steps];
      T_map_robot = T_map_robot * moved_by(step, log.robot().track_m, errors);
      travelled_m += 0.5 * (std::abs(step.left_m) + std::abs(step.right_m));
    }
    stands.push_back({placed(stand, T_map_robot * T_robot_axis, errors, full_readings),
                      travelled_m,
                      stand.piece});
  }
  return stands;
}

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

}  // namespace

double log_agreement(const StandLog& log,
                     const RobotErrors& errors,
                     const StandAgreementParams& params) {
  const auto stands = place_stands(log, errors, params.full_readings);
  double sum = 0.0;
  for (std::size_t stand = 1; stand < stands.size(); ++stand) {
    const auto least = least_disagreements(stands, stand, params);
    for (std::size_t i = 0; i < least.size(); ++i) {
      sum += stands[stand].surfaces[i].weight * std::log1p(params.weight * density(least[i]));
    }
  }
  return sum;
}

}  // namespace echomap::diagnosis
