// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "hil_mock/world/floor_plan.hpp"
#include "host/geometry/segment.hpp"
#include "host/mapping/cell_field.hpp"

namespace echomap::papers {

/// The room of Hennessey et al., section IV: 2.07 x 1.75 m with a door, in the middle of a grid of
/// 56 x 44 cells of 5 cm. What stands in it is ours: two boxes and a low block.
struct Playground {
  /// What the sonar hears: without the low block.
  world::FloorPlan heard;
  /// What the bumper meets.
  world::FloorPlan met;
  /// The room's four walls, less the door.
  std::vector<geometry::Segment> known_walls;
};

Playground make_playground();

/// What section II.B does, in parts.
struct PatchDriveParams {
  /// "We initialize the coordinates corresponding to the playground walls as one."
  bool with_known_walls = true;
  bool with_bumps = true;
  /// Dead reckoning errs as hil_mock/robots/ev3.toml says.
  bool with_drift = true;
};

/// What a drive through the seven phases has brought.
struct PatchDrive {
  mapping::CellField confidence;
  /// The echoes on the axis of their beams, where the robot believed them; grid frame.
  std::vector<Eigen::Vector2d> echoes_m;
  int bumps = 0;
  /// At the end of the drive, believed against true.
  double final_error_m = 0.0;
};

PatchDrive map_playground(const Playground& playground,
                          const PatchDriveParams& params,
                          std::uint32_t seed);

}  // namespace echomap::papers
