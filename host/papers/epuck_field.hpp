// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "hil_mock/world/floor_plan.hpp"
#include "host/mapping/raster_map.hpp"
#include "host/papers/drive_path.hpp"

namespace echomap::papers {

/// From the middle of an e-puck to its hull.
constexpr double kEpuckRadiusM = 0.037;
/// z_max: an infra-red sensor sees so far.
constexpr double kEpuckReachM = 0.06;

/// Numbers that Mahmood and Ridao leave open. z_max is their 6 cm, a cell their millimetre.
struct EpuckGridParams {
  /// alpha and beta of Algorithm 3.
  double thickness_m = 0.004;
  double beam_width_rad = 0.1745;
  /// l_occ and l_free: of 0.9 and of 0.4.
  double occupied_log_odds = 2.2;
  double free_log_odds = -0.4;
  /// Errors of the overhead camera, whose pixels are a millimetre wide; standard deviations.
  double position_stddev_m = 0.001;
  double heading_stddev_rad = 0.01;
  int laps = 2;
  /// Algorithm 3 calls all of a beam free where nothing answers; otherwise it is left out.
  bool silence_is_free = true;
};

/// hil_mock/worlds/epuck_field.toml.
const world::FloorPlan& epuck_field();

/// A drive along walls and obstacles of hil_mock/worlds/epuck_field.toml, cut into poses; the first
/// lies `phase` of a step behind its beginning.
std::vector<geometry::Pose2> epuck_lap(const PathSteps& steps, double phase);

/// Drives the simulated e-puck along walls and obstacles of hil_mock/worlds/epuck_field.toml and
/// maps it in cells of 1 mm by Algorithms 2 and 3. World frame.
mapping::RasterMap map_epuck_field(const world::FloorPlan& field,
                                   const EpuckGridParams& params,
                                   std::uint32_t seed);

/// The same drives as RobotPipeline maps them: in cells of 1 cm by mapping::ContactMapper.
mapping::RasterMap map_epuck_contacts(const world::FloorPlan& field, std::uint32_t seed);

}  // namespace echomap::papers
