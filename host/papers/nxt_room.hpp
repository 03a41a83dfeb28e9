// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "hil_mock/world/floor_plan.hpp"

namespace echomap::papers {

/// What is tried of Singh and Bedi 2013, section 4. Without change, it is the paper's text.
struct NxtTrial {
  std::size_t particles = 250;
  double sense_stddev_m = 0.03;
  /// As Algorithm 1 is printed: particles are drawn after each reading (line 33 stands in the loop
  /// of line 6), not after the eight that equation (1) multiplies.
  bool draws_after_each_reading = false;
  /// Spread of what is drawn; the paper has none.
  double spread_m = 0.0;
  double spread_rad = 0.0;
};

/// Where the particles are after 10 rounds of 8 readings, a turn by 20 degrees and 6 cm.
struct NxtOutcome {
  double error_m = 0.0;
  double heading_error_rad = 0.0;
  /// The same against where a robot would be that hears the same in a room turned by half: an
  /// empty rectangle cannot be told from that.
  double twin_error_m = 0.0;
  double twin_heading_error_rad = 0.0;
  /// Of the particles, as the filter has it.
  double stddev_m = 0.0;
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
