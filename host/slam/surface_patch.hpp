// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "host/mapping/wall_echo.hpp"

namespace echomap::slam {

/// When echoes are taken for one piece of surface. Ours, chosen on logs with 8 to 24 cones, 12 to
/// 60 beams and one panned sonar.
struct SurfacePatchParams {
  /// Echoes are asked that lie this near to each other, besides half of what a beam is wide there.
  double reach_m = 0.35;
  /// So many echoes make a patch, at least, and such a share of those that were asked.
  std::size_t min_echoes = 4;
  double min_agreement = 0.7;
  /// Echoes of one patch differ from it by so much, root mean square.
  double max_rms_m = 0.03;
  /// Measured points lie so far from the first to the last one.
  double min_length_m = 0.12;
  /// A direction less well known than this is none.
  double max_normal_stddev_rad = 0.25;
  /// Noise of an echo, for what the patch is worth.
  double echo_stddev_m = 0.02;
  /// One patch for each stretch of surface of this length.
  double spacing_m = 0.15;
};

/// Throws std::invalid_argument for invalid parameters.
void validate(const SurfacePatchParams& params);

/// A small piece of surface as some echoes have seen it together.
struct SurfacePatch {
  Eigen::Vector2d point_m = Eigen::Vector2d::Zero();
  /// Away from the side that is seen.
  double normal_rad = 0.0;
  /// How far the surface may lie behind or before the point.
  double offset_stddev_m = 0.0;
  double normal_stddev_rad = 0.0;
};

/// The patches that explain echoes taken from places that are well known to each other. A lone cone
/// does not say from where in it the echo came; neighbours do, as the sonar moves or turns: a line
/// is fitted to their ranges by what a beam would measure of it (view_of_wall), not to points.
/// Echoes that no line explains, as of clutter and ghosts, give none.
std::vector<SurfacePatch> find_patches(const std::vector<mapping::Echo>& echoes,
                                       const SurfacePatchParams& params);

}  // namespace echomap::slam
