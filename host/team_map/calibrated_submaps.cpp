// SPDX-License-Identifier: MIT
#include "host/team_map/calibrated_submaps.hpp"

#include <utility>

#include "host/slam/turn_calibration.hpp"

namespace echomap::team_map {

using geometry::Pose2;

void CalibratedSubmaps::take(const std::vector<Submap>& submaps) {
  if (submaps.size() < submaps_.size()) {
    submaps_.clear();
  }
  if (submaps_.empty() && !submaps.empty()) {
    begin(submaps.front());
  }
  for (std::size_t i = submaps_.size(); i < submaps.size(); ++i) {
    add(submaps[i]);
  }
}

void CalibratedSubmaps::begin(const Submap& first) {
  const auto share = slam::turn_share(first.readings, {});
  calibration_ =
      share ? std::optional(slam::OdometryCalibration{{*share, 0.0, 0.0}}) : std::nullopt;
  reported_mark_ = first.readings.front().mark;
  T_odom_robot_ = reported_mark_.T_odom_robot;
}

void CalibratedSubmaps::add(Submap submap) {
  if (calibration_) {
    Pose2 T_way_odom;
    for (slam::StopReading& reading : submap.readings) {
      const slam::OdometryMark now = reading.mark;
      T_odom_robot_ =
          T_odom_robot_ * slam::calibrated(slam::piece_between(reported_mark_, now), *calibration_);
      reported_mark_ = now;
      reading.mark.T_odom_robot = T_odom_robot_;
      reading.mark.turn_rad *= 1.0 + calibration_->turn_share();
      if (&reading == &submap.readings.front()) {
        T_way_odom = T_odom_robot_ * now.T_odom_robot.inverse();
      }
    }
    for (Pose2& T_odom_way : submap.T_odom_way) {
      T_odom_way = T_way_odom * T_odom_way;
    }
    for (SubmapContact& contact : submap.contacts) {
      contact.T_odom_robot = T_way_odom * contact.T_odom_robot;
    }
  }
  submaps_.push_back(std::move(submap));
}

}  // namespace echomap::team_map
