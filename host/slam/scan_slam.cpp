// SPDX-License-Identifier: MIT
#include "host/slam/scan_slam.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/LU>

#include "host/geometry/parameter_validator.hpp"
#include "host/sensors/range_scan.hpp"

namespace echomap::slam {

using geometry::Pose2;

namespace {

/// The first pose is where the map begins; so much is left of doubt for the algebra's sake.
constexpr double kKnownVariance = 1e-8;

}  // namespace

ScanSlam::ScanSlam(const ScanSlamParams& params)
    : params_(params),
      motion_(params.motion),
      gathering_(params.gathering),
      matcher_(params.matching),
      loops_(params.loops, params.search, params.matching, params.field),
      frames_(params.graph),
      field_(params.field) {
  geometry::ParameterValidator("scan SLAM")
      .positive("min_spread_m", params.min_spread_m)
      .positive("min_spread_rad", params.min_spread_rad)
      .positive("key_frame_m", params.key_frame_m)
      .positive("key_frame_rad", params.key_frame_rad)
      .positive("local_distance_m", params.local_distance_m)
      .positive("renewal_distance_m", params.renewal_distance_m);
}

void ScanSlam::add(const Pose2& T_odom_robot, const sensors::RangeScan& scan) {
  predict(T_odom_robot);
  gathering_.add(T_odom_robot, scan);
  if (!gathering_.is_enough() && !frames_.empty()) {
    return;
  }
  std::vector<Eigen::Vector2d> points_m = gathering_.points_m();
  const Eigen::Matrix3d information = place(points_m);
  if (const auto here = frame_here()) {
    go_to_frame(*here);
  } else {
    begin_frame(std::move(points_m), information);
    close_loops();
  }
  if (field_distance_m_ > params_.renewal_distance_m) {
    renew_field();
  }
  settle_gathered();
}

void ScanSlam::predict(const Pose2& T_odom_robot) {
  if (!T_odom_last_) {
    belief_ = {T_odom_robot, kKnownVariance * Eigen::Matrix3d::Identity()};
  } else {
    const models::OdometryStep step = models::odometry_step(*T_odom_last_, T_odom_robot);
    models::MotionSpread spread = motion_.spread(step);
    spread.drive_m = std::hypot(spread.drive_m, params_.min_spread_m);
    spread.side_m = std::hypot(spread.side_m, params_.min_spread_m);
    spread.turn_after_rad = std::hypot(spread.turn_after_rad, params_.min_spread_rad);
    belief_ = localization::moved(belief_, T_odom_last_->inverse() * T_odom_robot, step, spread);
  }
  T_odom_last_ = T_odom_robot;
}

Eigen::Matrix3d ScanSlam::place(const std::vector<Eigen::Vector2d>& points_m) {
  // Scans that were gathered along a way tell that there was one.
  last_match_ = gathering_.scans().size() == 1
                    ? matcher_.match_after(points_m, T_map_placed_, belief_, field_)
                    : matcher_.match(points_m, belief_, field_);
  Eigen::Matrix3d information = belief_.covariance.inverse() + last_match_.information;
  belief_ = {last_match_.T_map_robot, information.inverse()};
  return information;
}

std::optional<std::size_t> ScanSlam::frame_here() const {
  if (!around_.empty() && steps_from(frame_) <= 1.0) {
    return frame_;
  }
  const auto nearest =
      std::min_element(around_.begin(), around_.end(), [this](std::size_t one, std::size_t other) {
        return steps_from(one) < steps_from(other);
      });
  if (nearest == around_.end() || steps_from(*nearest) > 1.0) {
    return std::nullopt;
  }
  return *nearest;
}

double ScanSlam::steps_from(std::size_t frame) const {
  const Pose2 T_frame_robot = frames_.T_map_frame(frame).inverse() * belief_.T_map_robot;
  const double scale =
      last_match_.share < params_.new_ground_share ? params_.new_ground_scale : 1.0;
  return std::max(T_frame_robot.position_m().norm() / params_.key_frame_m,
                  std::abs(T_frame_robot.heading_rad()) / params_.key_frame_rad) /
         scale;
}

void ScanSlam::go_to_frame(std::size_t frame) {
  field_distance_m_ +=
      (frames_.T_map_frame(frame).position_m() - frames_.T_map_frame(frame_).position_m()).norm();
  frame_ = frame;
}

void ScanSlam::begin_frame(std::vector<Eigen::Vector2d> points_m,
                           const Eigen::Matrix3d& information) {
  KeyFrame frame{std::move(points_m), {}};
  // NOLINTNEXTLINE(bugprone-unchecked-optional-access): a scan was added
  const Pose2 T_now_odom = T_odom_last_->inverse();
  for (const GatheredScan& gathered : gathering_.scans()) {
    frame.scans.push_back({T_now_odom * gathered.T_odom_robot, gathered.scan});
  }
  const std::size_t newest = frames_.add(belief_.T_map_robot, std::move(frame));
  if (newest > 0) {
    frames_.join({frame_,
                  newest,
                  frames_.T_map_frame(frame_).inverse() * belief_.T_map_robot,
                  with_spread(in_frame_of(belief_.T_map_robot, information),
                              params_.frame_spread_m,
                              params_.frame_spread_rad),
                  false});
  }
  go_to_frame(newest);
  around_.push_back(newest);
  field_.add(frames_.map_points_m(newest));
}

void ScanSlam::close_loops() {
  std::vector<PoseEdge> loops;
  if (params_.closes_loops) {
    loops = loops_.close(frames_);
  }
  if (!loops.empty() && frames_.close_loops(loops)) {
    belief_.T_map_robot = frames_.T_map_frame(frame_);
    renew_field();
  }
}

void ScanSlam::renew_field() {
  field_.clear();
  around_.clear();
  for (const NearFrame& near : frames_.near(frame_, params_.local_distance_m)) {
    around_.push_back(near.frame);
    field_.add(frames_.map_points_m(near.frame));
  }
  field_distance_m_ = 0.0;
}

void ScanSlam::settle_gathered() {
  const Pose2 T_frame_odom =
      // NOLINTNEXTLINE(bugprone-unchecked-optional-access): a scan was added
      frames_.T_map_frame(frame_).inverse() * belief_.T_map_robot * T_odom_last_->inverse();
  for (const GatheredScan& gathered : gathering_.scans()) {
    places_.push_back({frame_, T_frame_odom * gathered.T_odom_robot});
  }
  gathering_.clear();
  T_map_placed_ = belief_.T_map_robot;
}

std::vector<Pose2> ScanSlam::trajectory() const {
  std::vector<Pose2> T_map_robots;
  T_map_robots.reserve(places_.size() + gathering_.scans().size());
  for (const ScanPlace& place : places_) {
    T_map_robots.push_back(frames_.T_map_frame(place.frame) * place.T_frame_robot);
  }
  for (const GatheredScan& gathered : gathering_.scans()) {
    // NOLINTNEXTLINE(bugprone-unchecked-optional-access): a scan was added
    T_map_robots.push_back(belief_.T_map_robot * (T_odom_last_->inverse() * gathered.T_odom_robot));
  }
  return T_map_robots;
}

}  // namespace echomap::slam
