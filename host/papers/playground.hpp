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
  /// The room without the low block, as the sonar measures it.
  world::FloorPlan for_sonar;
  /// The room with the block, as the bumper meets it.
  world::FloorPlan for_bumper;
  /// The room's four walls, less the door.
  std::vector<geometry::Segment> known_walls;
};

/// Makes the room with its boxes and its low block.
Playground make_playground();

/// Parts of section II.B, each to be left out.
struct PatchDriveParams {
  /// "We initialize the coordinates corresponding to the playground walls as one."
  bool with_known_walls = true;
  bool with_bumps = true;
  /// Dead reckoning errs as hil_mock/robots/ev3.toml says.
  bool with_drift = true;
};

/// Result of a drive through the seven phases.
struct PatchDrive {
  mapping::CellField confidence;
  /// The echoes on the axis of their beams, by the estimated poses; grid frame.
  std::vector<Eigen::Vector2d> echoes_m;
  int bumps = 0;
  /// Error of the estimated position at the end of the drive.
  double final_error_m = 0.0;
};

/// Drives through the seven phases and maps the playground on the way.
PatchDrive map_playground(const Playground& playground,
                          const PatchDriveParams& params,
                          std::uint32_t seed);

}  // namespace echomap::papers
