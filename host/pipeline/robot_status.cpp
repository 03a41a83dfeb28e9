// SPDX-License-Identifier: MIT
#include "host/pipeline/robot_status.hpp"

namespace echomap::pipeline {

NewBumps RobotStatus::on_hazards(const sensors::HazardObservation& observation) {
  times_lifted_ += observation.is_in_the_air() && !hazards_.is_in_the_air() ? 1 : 0;
  const NewBumps bumps{observation.bump_left && !hazards_.bump_left,
                       observation.bump_right && !hazards_.bump_right};
  hazards_ = observation;
  return bumps;
}

void RobotStatus::on_carried() {
  hazards_ = {};
  times_lifted_ = 0;
}

void RobotStatus::describe(Snapshot& snapshot) const {
  snapshot.hazards = hazards_;
  snapshot.infrared = infrared_;
  snapshot.yaw = yaw_;
  snapshot.battery = battery_;
  snapshot.times_lifted = times_lifted_;
}

}  // namespace echomap::pipeline
