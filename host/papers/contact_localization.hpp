// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "hil_mock/world/floor_plan.hpp"
#include "host/geometry/pose2.hpp"
#include "host/models/linear_odometry_motion.hpp"

namespace echomap::papers {

/// Settings of the particle filter of Mukherjee et al., section V; as told by default, but for the
/// number of particles, which the paper does not give.
struct ContactTrial {
  std::size_t particles = 1000;
  double alpha_scale = 1.0;  ///< Factor of alpha1 .. alpha4.
  double likelihood_exponent = 1.0;
  double spread = 0.0;  ///< Standard deviation added to resampled particles, metres and radians.
  double resampling_share = 1.0;  ///< Resampled below this share of the effective sample size.
};

/// Result of one run.
struct ContactOutcome {
  double error_m = 0.0;
  double heading_error_rad = 0.0;
  double outside_share = 0.0;                      ///< Share of the particles outside of the room.
  geometry::Pose2 T_world_robot;                   ///< In truth, at the end.
  std::vector<Eigen::Vector2d> first_particles_m;  ///< After the first step; world frame.
  std::vector<Eigen::Vector2d> last_particles_m;
};

/// A room with one reflex corner and without symmetry.
const world::FloorPlan& contact_room();

/// Localizes a Create by bumper and virtual wall while it bounces about in `contact_room`, until it
/// has bumped 25 times.
ContactOutcome localize_by_contacts(const ContactTrial& trial, std::uint32_t seed);

/// The alphas of equations 9 and 10, as mean errors of 70 drives of 360 mm and 70 turns by 360
/// degrees of a simulated Create (section VI).
models::LinearOdometryMotionParams mean_odometry_errors(std::uint32_t seed);

/// Factor of a mean absolute error that makes the paper's sampler, whose standard deviation is a
/// third of its argument, err by as much: 3 / sqrt(2 / pi).
double mean_error_scale();

}  // namespace echomap::papers
