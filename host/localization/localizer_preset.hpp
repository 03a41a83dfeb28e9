// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>

#include "host/localization/monte_carlo_localizer.hpp"
#include "host/localization/observation_model.hpp"
#include "host/mapping/raster_map.hpp"

namespace echomap::localization {

/// A way to put a localizer together: the papers' and ours.
enum class LocalizerPreset : std::uint8_t {
  kDefault,  ///< Ours.
  kNxt,      ///< Singh and Bedi 2013, section 4: ranges in a cloud of points, 250 particles.
  kCreate,   ///< Mukherjee et al., section V: contacts in an outline.
  kEpuck,    ///< Mahmood and Ridao 2017, section 3.3: correlation with a grid, 1,000 particles.
};

/// The sensor by which a robot is localized.
enum class LocalizedBy : std::uint8_t {
  kSonar,     ///< Weighted by the first wall in its cone.
  kLaser,     ///< Weighted by where its beams end.
  kInfrared,  ///< A ring of short range: weighted by the walls in reach, and by their absence.
  kContacts,  ///< Bumper and virtual wall, and a wall sensor where there is one.
};

/// What a preset has to know of a robot.
struct LocalizedRobot {
  /// Half of the range sensor's cone, radians; 0 for a thin beam.
  double beam_half_angle_rad = 0.2618;
  /// What is farther off does not answer, metres; 0 where the robot only has contacts.
  double max_range_m = 4.0;
  LocalizedBy by = LocalizedBy::kSonar;
  /// Of a round body with a bumper in front; that of an iRobot Create.
  double body_radius_m = 0.165;
};

/// Motion model, number of particles, resampling and all else that a preset asks of the filter.
LocalizerParams localizer_params(LocalizerPreset preset, const LocalizedRobot& robot);

/// The observation model of a preset. Throws std::invalid_argument for an invalid robot, and for
/// contacts and a ring of infra-red where no floor of the map has an outline.
std::unique_ptr<ObservationModel> observation_model(LocalizerPreset preset,
                                                    const mapping::RasterMap& map,
                                                    const LocalizedRobot& robot);

/// What compares places of a map that a robot has made itself by sonar, for the default preset:
/// where the known floor ends, anything may be heard.
std::unique_ptr<ObservationModel> own_map_model(const mapping::RasterMap& map,
                                                const LocalizedRobot& robot);

}  // namespace echomap::localization
