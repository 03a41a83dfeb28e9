// SPDX-License-Identifier: MIT
#include "host/localization/peer_sighting.hpp"

#include <cmath>

#include "host/geometry/square.hpp"
#include "host/geometry/unit_vector.hpp"

namespace echomap::localization {

namespace {

/// As good as none: no heading is farther off than half a turn.
constexpr double kAnyHeadingVariance = 100.0;

using geometry::square;

/// Along and across the line of sight, in the map.
Eigen::Matrix2d line_of_sight(const PeerSighting& sighting, const PoseGaussian& observer) {
  const Eigen::Vector2d along =
      geometry::unit_vector(observer.T_map_robot.heading_rad() + sighting.bearing_rad);
  Eigen::Matrix2d axes;
  axes << along.x(), -along.y(), along.y(), along.x();
  return axes;
}

}  // namespace

LandmarkObservation peer_as_landmark(const PeerSighting& sighting,
                                     const PoseGaussian& observer,
                                     const PoseGaussian& peer) {
  const Eigen::Matrix2d axes = line_of_sight(sighting, observer);
  const Eigen::Matrix2d unsure_m2 =
      kTold * axes.transpose() * peer.covariance.topLeftCorner<2, 2>() * axes;
  LandmarkObservation seen;
  seen.stamp_s = sighting.stamp_s;
  seen.landmark_m = peer.T_map_robot.position_m();
  seen.range_m = sighting.range_m;
  seen.bearing_rad = sighting.bearing_rad;
  seen.range_stddev_m = std::sqrt(square(sighting.range_stddev_m) + unsure_m2(0, 0));
  seen.bearing_stddev_rad =
      std::sqrt(square(sighting.bearing_stddev_rad) + unsure_m2(1, 1) / square(sighting.range_m));
  return seen;
}

PoseFix peer_as_fix(const PeerSighting& sighting,
                    const PoseGaussian& observer,
                    const PoseGaussian& peer) {
  const Eigen::Matrix2d axes = line_of_sight(sighting, observer);
  const Eigen::Vector2d offset_m = sighting.range_m * axes.col(0);
  Eigen::Matrix<double, 2, 3> by_observer;
  by_observer << 1.0, 0.0, -offset_m.y(), 0.0, 1.0, offset_m.x();
  const Eigen::Vector2d variance(square(sighting.range_stddev_m),
                                 square(sighting.range_m * sighting.bearing_stddev_rad));
  const Eigen::Vector2d position_m = observer.T_map_robot.position_m() + offset_m;
  PoseFix fix;
  fix.stamp_s = sighting.stamp_s;
  fix.T_map_robot = {position_m.x(), position_m.y(), peer.T_map_robot.heading_rad()};
  fix.covariance.setZero();
  fix.covariance.topLeftCorner<2, 2>() =
      kTold * by_observer * observer.covariance * by_observer.transpose() +
      axes * variance.asDiagonal() * axes.transpose();
  fix.covariance(2, 2) = kAnyHeadingVariance;
  return fix;
}

}  // namespace echomap::localization
