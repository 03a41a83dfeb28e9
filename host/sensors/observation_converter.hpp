// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "host/sensors/infrared_curve.hpp"
#include "host/sensors/observations.hpp"
#include "host/sensors/robot_geometry.hpp"
#include "host/sensors/scalar_meter.hpp"
#include "host/sensors/tick_unwrapper.hpp"
#include "host/sensors/yaw_integrator.hpp"
#include "host/time/robot_time.hpp"
#include "protocol/telemetry_messages.hpp"
#include "protocol/version.hpp"

namespace echomap::sensors {

/// How an echo's flight time becomes a range.
struct SonarRangeParams {
  double speed_of_sound_m_s = 343.2;  ///< Dry air at 20 degrees C; +0.6 m/s per degree.
  double min_range_m = 0.04;  ///< Nearer is ringing of the transducer (Singh and Bedi 2013, 2.4).
  double max_range_m = 2.30;  ///< Farther is noise; depends on the sensor.
};

/// One infra-red range sensor.
struct InfraredSensor {
  std::uint8_t channel = 0;        ///< Of protocol::Ranges.
  geometry::Pose2 T_robot_sensor;  ///< Its x axis is the axis of its beam.
};

/// What a robot has beside wheels and sonar.
struct SensorParams {
  std::vector<InfraredSensor> infrared;
  std::optional<InfraredCurve> infrared_curve;  ///< Of all of them; there where they are.
  std::optional<GyroParams> gyro;
  /// Voltage of the battery at the converter's last count.
  std::optional<double> battery_full_scale_v;
  std::optional<ScalarParams> scalar;
};

/// Turns telemetry, integers on the robot's clock, into observations in SI units. Counters and
/// stamps are unwrapped over the whole session, so `convert` wants every message, in order of
/// arrival.
class ObservationConverter {
 public:
  /// Throws std::invalid_argument for an invalid geometry or invalid ranges.
  ObservationConverter(const RobotGeometry& geometry,
                       const SonarRangeParams& sonar,
                       const SensorParams& sensors = {});

  OdometryObservation convert(const protocol::Odometry& message);
  /// `range_m` is empty for no echo and for ranges outside of the sonar's. `has_answered` is false
  /// for kNoSonar. Firmware that does not send it is taken for dead by many kNoEcho in a row.
  SonarObservation convert(const protocol::Echo& message);
  InfraredObservation convert(const protocol::Ranges& message);
  /// Empty where the robot has no gyro.
  std::optional<YawObservation> convert(const protocol::Gyro& message);
  /// A robot that is not armed may not know yet how its contacts are wired: its bumpers do not
  /// count.
  HazardObservation convert(const protocol::Status& message);
  /// `known`, with the bumpers and the stamp of `message`, which was converted before.
  HazardObservation with_bumps_of(const protocol::Odometry& message, HazardObservation known);
  /// Empty where no battery is measured.
  std::optional<BatteryObservation> convert(const protocol::Health& message);

  EncoderErrorObservation convert(const protocol::EncoderErrors& message);
  /// Empty where the robot has no scalar sensor, and where ScalarMeter has no reading.
  std::optional<ScalarObservation> convert(const protocol::Scalar& message);

  /// Which firmware sends the messages that follow: the minor version of its protocol.
  void set_protocol_minor(std::uint8_t minor) { protocol_minor_ = minor; }
  /// The robot was reset, and `passed` since its last message: its counters and its clock start at
  /// zero, travel and stamps go on.
  void restart(time::RobotClock::duration passed = time::RobotClock::duration::zero());

 private:
  WheelTravel travel(std::int16_t left_ticks, std::int16_t right_ticks);
  std::optional<double> range_m(std::uint16_t flight_us) const;
  bool has_answered(std::uint16_t flight_us);

  RobotGeometry geometry_;
  SonarRangeParams sonar_;
  SensorParams sensors_;
  std::uint8_t protocol_minor_ = protocol::kProtocolMinor;
  int pings_in_vain_ = 0;  ///< In a row.
  std::optional<YawIntegrator> yaw_;
  std::optional<ScalarMeter> scalar_;
  time::RobotTimeUnwrapper time_;
  TickUnwrapper left_;
  TickUnwrapper right_;
  TickUnwrapper left_errors_;
  TickUnwrapper right_errors_;
};

}  // namespace echomap::sensors
