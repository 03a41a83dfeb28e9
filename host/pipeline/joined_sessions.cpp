// SPDX-License-Identifier: MIT
#include "host/pipeline/joined_sessions.hpp"

#include <algorithm>
#include <variant>

namespace echomap::pipeline {

void JoinedSessions::begin_next() {
  sink_.end_scan();
  sink_.on_hazards({.stamp = last_stamp_});
  stamp_shift_.reset();
  travel_shift_.reset();
}

void JoinedSessions::on(const sensors::Observation& observation) {
  sensors::Observation shifted = observation;
  std::visit(
      [this](auto& one) {
        if constexpr (requires { one.stamp; }) {
          one.stamp = joined(one.stamp);
        }
        if constexpr (requires { one.travel; }) {
          one.travel = joined(one.travel);
        }
      },
      shifted);
  hand_on(shifted, sink_);
}

time::RobotTime JoinedSessions::joined(time::RobotTime stamp) {
  if (!stamp_shift_) {
    stamp_shift_ = last_stamp_ - stamp;
  }
  const time::RobotTime shifted = stamp + *stamp_shift_;
  last_stamp_ = std::max(last_stamp_, shifted);
  return shifted;
}

sensors::WheelTravel JoinedSessions::joined(const sensors::WheelTravel& travel) {
  if (!travel_shift_) {
    travel_shift_ = {last_travel_.left_m - travel.left_m, last_travel_.right_m - travel.right_m};
  }
  last_travel_ = {travel.left_m + travel_shift_->left_m, travel.right_m + travel_shift_->right_m};
  return last_travel_;
}

}  // namespace echomap::pipeline
