// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "host/pipeline/observation_sink.hpp"

namespace echomap::pipeline {

/// Makes one session of several: hands on what each senses, with stamps and wheel travel that go on
/// from where the session before ended.
class JoinedSessions final : public ObservationSink {
 public:
  /// `sink` outlives this.
  explicit JoinedSessions(ObservationSink& sink) : sink_(sink) {}

  /// What comes from here on is of the next session, whose clock and wheels count from anywhere and
  /// whose robot begins where it stood. Ends a scan that is open; what touched the robot or lifted
  /// it is over.
  void begin_next();

  void on_odometry(const sensors::OdometryObservation& observation) override;
  void on_sonar(const sensors::SonarObservation& observation) override;
  void on_hazards(const sensors::HazardObservation& observation) override;
  void on_infrared(const sensors::InfraredObservation& observation) override;
  void on_carried(const sensors::CarriedObservation& observation) override;
  void on_pose_fix(const sensors::PoseFixObservation& observation) override;
  void on_yaw(const sensors::YawObservation& observation) override;
  void on_battery(const sensors::BatteryObservation& observation) override;
  void begin_scan() override { sink_.begin_scan(); }
  void end_scan() override { sink_.end_scan(); }

 private:
  time::RobotTime joined(time::RobotTime stamp);
  sensors::WheelTravel joined(const sensors::WheelTravel& travel);

  ObservationSink& sink_;
  time::RobotTime last_stamp_;  ///< The latest that was handed on.
  sensors::WheelTravel last_travel_;
  /// What this session's own are shifted by; empty until the first of them tells.
  std::optional<time::RobotClock::duration> stamp_shift_ = time::RobotClock::duration::zero();
  std::optional<sensors::WheelTravel> travel_shift_ = sensors::WheelTravel{};
};

}  // namespace echomap::pipeline
