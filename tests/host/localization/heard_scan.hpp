// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

#include "host/geometry/angle.hpp"
#include "host/geometry/unit_vector.hpp"
#include "host/localization/localizer_preset.hpp"
#include "host/localization/observation_model.hpp"
#include "host/mapping/ray_casting.hpp"

namespace echomap::tests {

inline constexpr double kEarRangeM = 3.0;
inline constexpr double kEarHalfAngleDeg = 13.0;

/// That of the default preset, for the sonar of heard_scan().
inline std::unique_ptr<localization::ObservationModel> sonar_model(const mapping::RasterMap& map) {
  localization::LocalizedRobot robot;
  robot.beam_half_angle_rad = geometry::radians(kEarHalfAngleDeg);
  robot.max_range_m = kEarRangeM;
  return localization::observation_model(localization::LocalizerPreset::kDefault, map, robot);
}

/// All round in steps of 6 degrees: the nearest thing in the cone.
inline std::vector<localization::RangeReading> heard_scan(const mapping::RasterMap& map,
                                                          const geometry::Pose2& T_map_robot) {
  const mapping::DistanceField field(map, kEarRangeM);
  std::vector<localization::RangeReading> readings;
  for (int bearing_deg = 0; bearing_deg < 360; bearing_deg += 6) {
    auto nearest_m = static_cast<float>(kEarRangeM);
    for (int aside_deg = -12; aside_deg <= 12; aside_deg += 3) {
      const Eigen::Vector2f direction =
          geometry::unit_vector(T_map_robot.heading_rad() +
                                geometry::radians(bearing_deg + aside_deg))
              .cast<float>();
      float range_m = 0.0F;
      mapping::cast_rays(
          field, T_map_robot.position_m(), {&direction, 1}, kEarRangeM, {&range_m, 1});
      nearest_m = std::min(nearest_m, range_m);
    }
    const bool is_heard = nearest_m < static_cast<float>(kEarRangeM);
    readings.push_back({{0.0, 0.0, geometry::radians(bearing_deg)},
                        is_heard ? std::optional<double>(nearest_m) : std::nullopt});
  }
  return readings;
}

}  // namespace echomap::tests
