// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "hil_mock/world/floor_plan.hpp"
#include "host/geometry/pose2.hpp"

namespace echomap::papers {

/// Settings of the particle filter of Singh and Bedi 2013, section 4; as told by default.
struct NxtTrial {
  std::size_t particles = 250;
  double sense_stddev_m = 0.03;
  /// As Algorithm 1 is printed: particles are resampled after each reading (line 33 stands in the
  /// loop of line 6), not after the eight that equation (1) multiplies.
  bool resamples_after_each_reading = false;
  /// Standard deviations added to resampled particles; the paper adds none.
  double spread_m = 0.0;
  double spread_rad = 0.0;
};

/// Result after 10 rounds of 8 readings, a turn by 20 degrees and 6 cm.
struct NxtOutcome {
  double error_m = 0.0;
  double heading_error_rad = 0.0;
  /// Errors against the pose with the same echoes in the room turned by half a turn: an empty
  /// rectangle is symmetric.
  double twin_error_m = 0.0;
  double twin_heading_error_rad = 0.0;
  /// Standard deviation of the particles' positions, both axes together.
  double stddev_m = 0.0;
  geometry::Pose2 T_world_robot;  ///< In truth, at the end.
  /// Positions of the particles after the first eight readings, and at the end; world frame.
  std::vector<Eigen::Vector2d> first_particles_m;
  std::vector<Eigen::Vector2d> last_particles_m;
};

/// The map of section 3.1: echoes of 120 readings from each of five places, metres in the world
/// frame. The sonar is that of hil_mock/robots/nxt_tribot.toml.
std::vector<Eigen::Vector2d> nxt_cloud(const world::FloorPlan& room, std::uint32_t seed);

/// The localization of section 4 with that map, from a place anywhere in the room.
NxtOutcome localize_nxt(const world::FloorPlan& room,
                        const std::vector<Eigen::Vector2d>& cloud_m,
                        const NxtTrial& trial,
                        std::uint32_t seed);

}  // namespace echomap::papers
