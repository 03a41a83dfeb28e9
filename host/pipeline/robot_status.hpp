// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>

#include "host/pipeline/snapshot.hpp"
#include "host/sensors/observations.hpp"

namespace echomap::pipeline {

/// A switch of either side that has just closed.
struct NewBumps {
  bool left = false;
  bool right = false;
};

/// The last that a robot has reported of itself, and how often it was picked up since it was last
/// put down at a known place: its pose is void once it was.
class RobotStatus {
 public:
  NewBumps on_hazards(const sensors::HazardObservation& observation);
  void on_infrared(const sensors::InfraredObservation& observation) { infrared_ = observation; }
  void on_yaw(const sensors::YawObservation& observation) { yaw_ = observation; }
  void on_battery(const sensors::BatteryObservation& observation) { battery_ = observation; }
  /// The robot stands where somebody has put it.
  void on_carried();

  bool has_void_pose() const { return times_lifted_ > 0; }
  void describe(Snapshot& snapshot) const;

 private:
  sensors::HazardObservation hazards_;
  sensors::InfraredObservation infrared_;
  std::optional<sensors::YawObservation> yaw_;
  std::optional<sensors::BatteryObservation> battery_;
  std::size_t times_lifted_ = 0;
};

}  // namespace echomap::pipeline
