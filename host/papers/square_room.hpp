// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "hil_mock/world/floor_plan.hpp"
#include "hil_mock/world/robot_params.hpp"
#include "host/sensors/range_scan.hpp"
#include "host/sensors/wall_beam_width.hpp"

namespace echomap::papers {

/// The sonar of hil_mock/robots/ev3.toml with a cone of that width.
world::SonarParams ev3_sonar(double beam_width_rad);

/// A square room, 1.4 m wide, of boards that scatter sound, as in figure 4 of Hennessey et al.
world::FloorPlan square_room();

/// What steps of a sweep are.
struct SweepSteps {
  double half_rad = 0.0;  ///< The sweep goes from minus this to this.
  double step_rad = 0.0;
};

/// Readings of a sonar at the origin of a room, by bearing.
std::vector<sensors::Beam> sweep(const world::FloorPlan& room,
                                 const world::SonarParams& sonar,
                                 const SweepSteps& steps,
                                 std::uint32_t seed);

/// Walls in four sweeps of a room, three degrees a step: a wide cone sees few walls in a small
/// room.
std::vector<sensors::SweptWall> walls_of_room(const world::FloorPlan& room,
                                              const world::SonarParams& sonar,
                                              std::uint32_t seed);

}  // namespace echomap::papers
