// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "host/geometry/pose2.hpp"
#include "host/localization/pose_gaussian.hpp"

namespace echomap::papers {

/// When the overhead camera reports. As told by default: an image in each iteration, and at once
/// (Mahmood and Ridao 2017, section 4.1).
struct OverheadCamera {
  int every_steps = 1;
  double drop_share = 0.0;  ///< Share of the images without a pose.
  int max_delay_steps = 0;  ///< A pose arrives up to so many steps late, evenly.
  int until_step = 1000;    ///< The camera reports until here.
};

/// A camera that is up to 0.6 s late and misses a fifth of its images.
OverheadCamera late_camera();

/// One iteration of the filter.
struct EkfStep {
  geometry::Pose2 T_world_robot;         ///< In truth.
  localization::PoseGaussian belief;     ///< At the end of the iteration; world frame.
  std::optional<Eigen::Vector2d> fix_m;  ///< Position in the image of this pose; world frame.
};

/// How the filter followed one drive.
struct EkfDrive {
  std::vector<EkfStep> steps;
  std::size_t gated = 0;  ///< Fixes that the filter rejected.
};

/// The initial belief: the middle of the field, unsure of all of it and of the heading.
localization::PoseGaussian anywhere_in_the_field();

/// Drives a simulated e-puck 2.9 m round its field, a step of 1 cm or 0.1 rad in each iteration,
/// and follows it by localization::PoseEkf (Algorithm 1) from `anywhere_in_the_field`.
EkfDrive follow_epuck(const OverheadCamera& camera, std::uint32_t seed);

/// Error of the estimate in x and y, metres, and heading, radians.
Eigen::Vector3d error_of(const EkfStep& step);

/// Standard deviation of the estimated position, metres: the root of both variances added.
double planar_stddev_m(const EkfStep& step);

/// Share of the errors in x, y and heading beyond three standard deviations.
double share_beyond_three_sigma(const EkfDrive& drive);

}  // namespace echomap::papers
