// SPDX-License-Identifier: MIT
#include "host/sensors/observation_converter.hpp"

#include <array>
#include <cmath>
#include <stdexcept>

#include "host/geometry/angle.hpp"
#include "host/geometry/parameter_validator.hpp"

namespace echomap::sensors {
namespace {

struct Bumps {
  bool left;
  bool right;
};

Bumps bumps_of(std::uint8_t flags) {
  const bool knows_its_wiring = (flags & protocol::kFlagArmed) != 0;
  return {knows_its_wiring && (flags & protocol::kFlagBumpLeft) != 0,
          knows_its_wiring && (flags & protocol::kFlagBumpRight) != 0};
}

/// A turn all round in the paper's steps of 6 degrees without an echo: of firmware that does not
/// tell a dead sonar from an open hall it is a dead sonar.
constexpr int kMaxPingsInVain = 60;

}  // namespace

ObservationConverter::ObservationConverter(const RobotGeometry& geometry,
                                           const SonarRangeParams& sonar,
                                           const SensorParams& sensors)
    : geometry_(geometry), sonar_(sonar), sensors_(sensors) {
  if (sensors_.gyro) {
    yaw_.emplace(*sensors_.gyro);
  }
  if (sensors_.scalar) {
    scalar_.emplace(*sensors_.scalar);
  }
  geometry_.validate();
  geometry::ParameterValidator("sonar")
      .finite("speed_of_sound_m_s", sonar_.speed_of_sound_m_s)
      .positive("speed_of_sound_m_s", sonar_.speed_of_sound_m_s);
  geometry::ParameterValidator("sonar")
      .at_least("min_range_m", sonar_.min_range_m, 0.0)
      .below("min_range_m", sonar_.min_range_m, sonar_.max_range_m);
  if (!sensors_.infrared.empty() && !sensors_.infrared_curve) {
    throw std::invalid_argument("infra-red sensors: no curve");
  }
}

OdometryObservation ObservationConverter::convert(const protocol::Odometry& message) {
  return {time_.unwrap(message.stamp_us), travel(message.left_ticks, message.right_ticks)};
}

SonarObservation ObservationConverter::convert(const protocol::Echo& message) {
  return {time_.unwrap(message.stamp_us),
          travel(message.left_ticks, message.right_ticks),
          geometry::wrap_angle(geometry::radians(message.pan_cdeg / 100.0)),
          range_m(message.flight_us),
          has_answered(message.flight_us)};
}

InfraredObservation ObservationConverter::convert(const protocol::Ranges& message) {
  const std::array channels{message.channel_0,
                            message.channel_1,
                            message.channel_2,
                            message.channel_3,
                            message.channel_4,
                            message.channel_5,
                            message.channel_6,
                            message.channel_7};
  InfraredObservation observation{
      time_.unwrap(message.stamp_us), travel(message.left_ticks, message.right_ticks), {}};
  for (const InfraredSensor& sensor : sensors_.infrared) {
    const std::uint16_t counts = channels.at(sensor.channel);
    const auto& curve = sensors_.infrared_curve;
    const bool is_read = curve && counts != protocol::kNoRange;
    observation.range_m.push_back(is_read ? curve->range_m(counts) : std::nullopt);
  }
  return observation;
}

std::optional<YawObservation> ObservationConverter::convert(const protocol::Gyro& message) {
  if (!yaw_) {
    return std::nullopt;
  }
  return YawObservation{time_.unwrap(message.stamp_us), yaw_->update(message)};
}

HazardObservation ObservationConverter::convert(const protocol::Status& message) {
  const auto [bump_left, bump_right] = bumps_of(message.flags);
  const auto hazard = [&](protocol::Hazard bit) { return (message.hazards & bit) != 0; };
  return {time_.unwrap(message.stamp_us),
          bump_left,
          bump_right,
          {hazard(protocol::kHazardCliffLeft),
           hazard(protocol::kHazardCliffFrontLeft),
           hazard(protocol::kHazardCliffFrontRight),
           hazard(protocol::kHazardCliffRight)},
          hazard(protocol::kHazardWheelDrop),
          hazard(protocol::kHazardVirtualWall),
          hazard(protocol::kHazardWall)};
}

HazardObservation ObservationConverter::with_bumps_of(const protocol::Odometry& message,
                                                      HazardObservation known) {
  known.stamp = time_.unwrap(message.stamp_us);
  const auto [bump_left, bump_right] = bumps_of(message.flags);
  known.bump_left = bump_left;
  known.bump_right = bump_right;
  return known;
}

std::optional<BatteryObservation> ObservationConverter::convert(const protocol::Health& message) {
  constexpr double kFullScaleCounts = 1023.0;
  if (!sensors_.battery_full_scale_v || message.battery_raw == 0) {
    return std::nullopt;
  }
  return BatteryObservation{
      time_.unwrap(message.stamp_us),
      message.battery_raw / kFullScaleCounts * *sensors_.battery_full_scale_v};
}

EncoderErrorObservation ObservationConverter::convert(const protocol::EncoderErrors& message) {
  return {time_.unwrap(message.stamp_us),
          left_errors_.unwrap(static_cast<std::int16_t>(message.left)),
          right_errors_.unwrap(static_cast<std::int16_t>(message.right))};
}

std::optional<ScalarObservation> ObservationConverter::convert(const protocol::Scalar& message) {
  const time::RobotTime stamp = time_.unwrap(message.stamp_us);
  const WheelTravel rolled = travel(message.left_ticks, message.right_ticks);
  const auto reading = scalar_ ? scalar_->update(message) : std::nullopt;
  if (!reading) {
    return std::nullopt;
  }
  return ScalarObservation{stamp, rolled, reading->count, reading->dwell_s};
}

void ObservationConverter::restart(time::RobotClock::duration passed) {
  if (yaw_) {
    yaw_->restart();
  }
  if (scalar_) {
    scalar_->restart();
  }
  time_.restart(passed);
  left_.restart();
  right_.restart();
  left_errors_.restart();
  right_errors_.restart();
}

WheelTravel ObservationConverter::travel(std::int16_t left_ticks, std::int16_t right_ticks) {
  const double metres_per_tick = geometry_.metres_per_tick();
  return {
      static_cast<double>(left_.unwrap(left_ticks)) * metres_per_tick * geometry_.left_wheel_scale,
      static_cast<double>(right_.unwrap(right_ticks)) * metres_per_tick *
          geometry_.right_wheel_scale};
}

std::optional<double> ObservationConverter::range_m(std::uint16_t flight_us) const {
  if (flight_us == protocol::kNoEcho || flight_us == protocol::kNoSonar) {
    return std::nullopt;
  }
  const double there_and_back_m = flight_us * 1e-6 * sonar_.speed_of_sound_m_s;
  const double range_m = there_and_back_m / 2.0;
  if (range_m < sonar_.min_range_m || range_m > sonar_.max_range_m) {
    return std::nullopt;
  }
  return range_m;
}

bool ObservationConverter::has_answered(std::uint16_t flight_us) {
  pings_in_vain_ = flight_us == protocol::kNoEcho ? pings_in_vain_ + 1 : 0;
  return protocol_minor_ >= protocol::kNoSonarSinceMinor ? flight_us != protocol::kNoSonar
                                                         : pings_in_vain_ <= kMaxPingsInVain;
}

}  // namespace echomap::sensors
