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

/// What a preset has to know of a robot.
struct LocalizedRobot {
  /// Half of the range sensor's cone, radians; 0 for a thin beam.
  double beam_half_angle_rad = 0.2618;
  /// What is farther off does not answer, metres.
  double max_range_m = 4.0;
  /// The sensor sees by light, as lasers and infra-red do: it is weighed by where its beams end.
  bool is_light = false;
  /// Of a round body with a bumper in front; that of an iRobot Create.
  double body_radius_m = 0.165;
};

/// Motion model, number of particles, resampling and all else that a preset asks of the filter.
LocalizerParams localizer_params(LocalizerPreset preset, const LocalizedRobot& robot);

/// The observation model of a preset. Throws std::invalid_argument for an invalid robot, and for
/// kCreate where no floor of the map has an outline.
std::unique_ptr<ObservationModel> observation_model(LocalizerPreset preset,
                                                    const mapping::RasterMap& map,
                                                    const LocalizedRobot& robot);

/// What compares places of a map that a robot has made itself by sonar, for the default preset:
/// where the known floor ends, anything may be heard.
std::unique_ptr<ObservationModel> own_map_model(const mapping::RasterMap& map,
                                                const LocalizedRobot& robot);

}  // namespace echomap::localization
