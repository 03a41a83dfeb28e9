// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "host/slam/landmark_sighting.hpp"
#include "host/slam/wall_echo.hpp"

namespace echomap::slam {

/// What a cone can hear: a wall, or a point that answers from all around, as an edge, a corner or a
/// leg does. All in the frame of the echoes.
struct EchoFeature {
  LandmarkKind kind = LandmarkKind::kPoint;
  /// By the kind, as a landmark has it: x and y (m), or offset (m) and direction of the normal.
  Eigen::Vector2d value = Eigen::Vector2d::Zero();
};

/// How echoes are taken for those of one thing; ours.
struct HearingParams {
  /// Ranges of one thing agree to this: 2 sigma.
  double tolerance_m = 0.06;
  /// By how much a wall may be slanted outside of the beam and be heard yet: an HC-SR04 falls
  /// silent 25 to 30 degrees off the axis (UNIVPM's measurements).
  double most_slant_rad = 0.26;
};

/// What a cone would measure of a feature, and how that changes with the feature's value.
struct FeatureEcho {
  double range_m = 0.0;
  Eigen::Vector2d range_by_feature = Eigen::Vector2d::Zero();
  /// Towards the feature's nearest point, whether in the cone or beside it.
  double bearing_rad = 0.0;
  Eigen::Vector2d bearing_by_feature = Eigen::Vector2d::Zero();
  double widest_off_axis_rad = 0.0;  ///< The cone hears it up to there.
};

/// Of a wall by view_of_wall, of a point by its distance. Empty where the cone does not hear it: a
/// point outside of it, a wall from behind or by more than `most_slant_rad` outside.
std::optional<FeatureEcho> echo_of(const EchoFeature& feature,
                                   const Echo& echo,
                                   double most_slant_rad);

/// Where along a wall a cone that hears it has its answer from: from the foot of the origin's
/// perpendicular, positive counter-clockwise.
double along_m(const EchoFeature& wall, const Echo& echo);

/// The features that explain two echoes: walls, of which each has measured the same (tangents of
/// both arcs, and what meets the edges of the cones), and points where the arcs cross. Of cones
/// that heard one thing from one place that is the wall, and the point, in their middle.
std::vector<EchoFeature> features_through(const Echo& first,
                                          const Echo& second,
                                          const HearingParams& hearing);

}  // namespace echomap::slam
