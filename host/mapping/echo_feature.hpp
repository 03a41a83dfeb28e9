// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "host/mapping/wall_echo.hpp"
#include "host/models/landmark_view.hpp"

namespace echomap::mapping {

/// A feature is a wall or a point, as a landmark is.
using models::LandmarkKind;

/// What a sonar can hear: a wall, or a point that answers from all around, as an edge, a corner, a
/// post or a leg does. All in the frame of the echoes.
struct EchoFeature {
  LandmarkKind kind = LandmarkKind::kPoint;
  /// By the kind, as a landmark has it: x and y (m), or offset (m) and direction of the normal.
  Eigen::Vector2d value = Eigen::Vector2d::Zero();
  /// Of a point that is the middle of something round: it answers so far before the point.
  double radius_m = 0.0;
};

/// How echoes are taken for those of one thing; ours.
struct HearingParams {
  /// Ranges of one thing agree to this: 2 sigma.
  double tolerance_m = 0.06;
  /// By how much a wall may be slanted outside of the beam and be heard yet: an HC-SR04 falls
  /// silent 25 to 30 degrees off the axis (UNIVPM's measurements).
  double max_incidence_rad = 0.26;
};

/// Range and bearing of a feature's nearest point. The range is negative behind a wall.
struct FeatureView {
  double range_m = 0.0;
  double bearing_rad = 0.0;
  /// Derivatives of range (first row) and bearing (second row) by the feature's value.
  Eigen::Matrix2d jacobian = Eigen::Matrix2d::Zero();
};

/// How a feature looks from a place, whatever way the sensor points. The range is that of its face.
FeatureView view_from(const Eigen::Vector2d& sensor_m, const EchoFeature& feature);

/// What a cone would measure of a feature; the bearing is that of the feature's nearest point,
/// whether in the cone or beside it.
struct FeatureEcho : FeatureView {
  double max_off_axis_rad = 0.0;  ///< The cone hears the feature up to there.
};

/// Of a wall by view_of_wall, of a point by its distance. Empty where the cone does not hear it: a
/// point outside of it, a wall from behind or by more than `max_incidence_rad` outside.
std::optional<FeatureEcho> echo_of(const EchoFeature& feature,
                                   const Echo& echo,
                                   double max_incidence_rad);

/// Where along a wall a cone that hears it has its answer from: from the foot of the origin's
/// perpendicular, positive counter-clockwise.
double along_m(const EchoFeature& wall, const Echo& echo);

/// A range without a bearing: what answered lies on a circle, or touches it.
struct RangeCircle {
  Eigen::Vector2d center_m = Eigen::Vector2d::Zero();
  double range_m = 0.0;
};

/// The features that fit two ranges: up to two walls, tangents of the two circles, and up to two
/// points, where the circles cross. None where the centres lie too near together.
std::vector<EchoFeature> features_through(const RangeCircle& first, const RangeCircle& second);

/// The round things of a radius that fit two ranges: up to two. None where the centres lie too near
/// together.
std::vector<EchoFeature> circles_through(const RangeCircle& first,
                                         const RangeCircle& second,
                                         double radius_m);

/// The features that explain two echoes: walls, of which each has measured the same (tangents of
/// both arcs, and what meets the edges of the cones), and points where the arcs cross. Of cones
/// that heard one thing from one place that is the wall, and the point, in their middle.
std::vector<EchoFeature> features_through(const Echo& first,
                                          const Echo& second,
                                          const HearingParams& hearing);

}  // namespace echomap::mapping
