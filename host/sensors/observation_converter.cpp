// SPDX-License-Identifier: MIT
#include "host/sensors/observation_converter.hpp"

#include <cmath>
#include <stdexcept>

#include "host/geometry/angle.hpp"

namespace echomap::sensors {

ObservationConverter::ObservationConverter(const RobotGeometry& geometry,
                                           const SonarRangeParams& sonar)
    : geometry_(geometry), sonar_(sonar) {
  geometry_.check();
  if (!std::isfinite(sonar_.speed_of_sound_m_s) || sonar_.speed_of_sound_m_s <= 0.0) {
    throw std::invalid_argument("sonar: speed_of_sound_m_s must be positive");
  }
  const bool is_interval = sonar_.min_range_m >= 0.0 && sonar_.min_range_m < sonar_.max_range_m;
  if (!is_interval) {
    throw std::invalid_argument("sonar: 0 <= min_range_m < max_range_m does not hold");
  }
}

OdometryObservation ObservationConverter::convert(const protocol::Odometry& message) {
  return {time_.unwrap(message.stamp_us), travel(message.left_ticks, message.right_ticks)};
}

SonarObservation ObservationConverter::convert(const protocol::Echo& message) {
  return {time_.unwrap(message.stamp_us),
          travel(message.left_ticks, message.right_ticks),
          geometry::wrap_angle(geometry::radians(message.pan_cdeg / 100.0)),
          range_m(message.flight_us)};
}

void ObservationConverter::restart() {
  time_.restart();
  left_.restart();
  right_.restart();
}

WheelTravel ObservationConverter::travel(std::int16_t left_ticks, std::int16_t right_ticks) {
  const double metres_per_tick = geometry_.metres_per_tick();
  return {static_cast<double>(left_.unwrap(left_ticks)) * metres_per_tick,
          static_cast<double>(right_.unwrap(right_ticks)) * metres_per_tick};
}

std::optional<double> ObservationConverter::range_m(std::uint16_t flight_us) const {
  if (flight_us == protocol::kNoEcho) {
    return std::nullopt;
  }
  const double there_and_back_m = flight_us * 1e-6 * sonar_.speed_of_sound_m_s;
  const double range_m = there_and_back_m / 2.0;
  if (range_m < sonar_.min_range_m || range_m > sonar_.max_range_m) {
    return std::nullopt;
  }
  return range_m;
}

}  // namespace echomap::sensors
