// SPDX-License-Identifier: MIT
#include "host/pipeline/log_player.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <variant>

#include "host/geometry/angle.hpp"
#include "host/sensors/odometry.hpp"

namespace echomap::pipeline {
namespace {

using namespace std::chrono_literals;

/// Later stamps, beyond the year 5000, are damage.
constexpr double kLatestStampS = 1e11;

std::optional<double> without_damage(std::optional<double> stamp_s) {
  return stamp_s && std::abs(*stamp_s) <= kLatestStampS ? stamp_s : std::nullopt;
}

/// The stamp of the next pose, which comes after the last one.
time::RobotTime rising(std::optional<double> stamp_s, std::optional<time::RobotTime> last) {
  if (!last) {
    return time::robot_time(stamp_s.value_or(0.0));
  }
  return stamp_s ? std::max(time::robot_time(*stamp_s), *last + 1us) : *last + 1ms;
}

}  // namespace

void LogPlayer::play(const datasets::LogRecord& record) {
  ++counts_.records;
  if (const auto stamp_s = without_damage(datasets::stamp_s(record))) {
    first_stamp_s_ = std::min(first_stamp_s_.value_or(*stamp_s), *stamp_s);
    latest_stamp_s_ = std::max(latest_stamp_s_.value_or(*stamp_s), *stamp_s);
  }
  std::visit([this](const auto& kind) { take(kind); }, record);
}

std::optional<double> LogPlayer::duration_s() const {
  if (!first_stamp_s_ || !latest_stamp_s_) {
    return std::nullopt;
  }
  return *latest_stamp_s_ - *first_stamp_s_;
}

void LogPlayer::take(const datasets::OdometryPose& pose) {
  const bool begins_here =
      source_ == PoseSource::kOdometryFromOrigin && counts_.odometry_poses == 0;
  if (begins_here) {
    T_log_odom_ = pose.T_odom_robot;
  }
  move_to(pose.stamp_s, T_log_odom_.inverse() * pose.T_odom_robot);
  if (begins_here) {
    // NOLINTNEXTLINE(bugprone-unchecked-optional-access): a pose was reported
    sink_->on_pose_fix({*last_stamp_, T_log_odom_});
  }
}

void LogPlayer::take(const datasets::OdometryStep& step) {
  move_to(step.stamp_s, T_odom_robot_ * step.T_last_now);
}

void LogPlayer::take(const datasets::WheelIncrement& wheels) {
  // Where there is a gyro, it knows the turn better than wheels that skid.
  const double turn_rad = heading_rad_ && used_heading_rad_
                              ? geometry::angle_between(*used_heading_rad_, *heading_rad_)
                              : (wheels.right_m - wheels.left_m) / wheels.track_m;
  used_heading_rad_ = heading_rad_;
  move_to(wheels.stamp_s,
          T_odom_robot_ * sensors::arc_step((wheels.left_m + wheels.right_m) / 2.0, turn_rad));
}

void LogPlayer::move_to(std::optional<double> stamp_s, const geometry::Pose2& T_odom_robot) {
  ++counts_.odometry_poses;
  T_odom_robot_ = T_odom_robot;
  if (source_ != PoseSource::kGiven || has_fix_) {
    report_pose(stamp_s);
  }
}

void LogPlayer::take(const datasets::GivenPose& pose) {
  ++counts_.given_poses;
  if (source_ != PoseSource::kGiven) {
    return;
  }
  const auto stamp_s = without_damage(pose.stamp_s);
  const bool is_of_last_pose = last_stamp_ && stamp_s && time::robot_time(*stamp_s) <= *last_stamp_;
  if (!is_of_last_pose) {
    report_pose(pose.stamp_s);
  }
  has_fix_ = true;
  // NOLINTNEXTLINE(bugprone-unchecked-optional-access): a pose was reported
  sink_->on_pose_fix({*last_stamp_, pose.T_map_robot});
}

void LogPlayer::report_pose(std::optional<double> stamp_s) {
  const auto own_s = without_damage(stamp_s);
  counts_.poses_without_stamp += own_s ? 0 : 1;
  last_stamp_ = rising(own_s, last_stamp_);
  sink_->on_odometry_pose({*last_stamp_, T_odom_robot_});
}

bool LogPlayer::is_placed(std::optional<double> stamp_s) {
  if (!last_stamp_ && source_ != PoseSource::kGiven) {
    report_pose(stamp_s);
  }
  return last_stamp_.has_value();
}

void LogPlayer::take(const sensors::RangeScan& scan) {
  ++counts_.scans;
  counts_.beams += scan.beams.size();
  if (is_placed(scan.stamp_s)) {
    sink_->on_range_scan(scan);
  } else {
    ++counts_.scans_without_pose;
  }
}

void LogPlayer::take(const datasets::Contact& contact) {
  const bool is_new = (contact.bump_left && !last_contact_.bump_left) ||
                      (contact.bump_right && !last_contact_.bump_right);
  counts_.bumps += is_new ? 1 : 0;
  last_contact_ = contact;
  if (is_placed(contact.stamp_s)) {
    sensors::HazardObservation hazards;
    // NOLINTNEXTLINE(bugprone-unchecked-optional-access): a pose was reported
    hazards.stamp = *last_stamp_;
    hazards.bump_left = contact.bump_left;
    hazards.bump_right = contact.bump_right;
    hazards.bumper_radius_m = contact.bumper_radius_m;
    sink_->on_hazards(hazards);
  }
}

void LogPlayer::take(const datasets::LandmarkSighting& sighting) {
  ++counts_.sightings;
  if (is_placed(sighting.stamp_s)) {
    sink_->on_landmark({sighting.id, sighting.range_m, sighting.bearing_rad});
  } else {
    ++counts_.sightings_without_pose;
  }
}

}  // namespace echomap::pipeline
