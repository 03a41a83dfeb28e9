// SPDX-License-Identifier: MIT
#include "host/slam/scan_slam.hpp"

#include <cmath>
#include <iterator>
#include <limits>

#include <Eigen/LU>

#include "host/geometry/angle.hpp"
#include "host/mapping/ray_insertion.hpp"

namespace echomap::slam {

using geometry::Pose2;

namespace {

std::vector<Eigen::Vector2d> spaced(const std::vector<Eigen::Vector2d>& points_m, double spacing_m) {
  std::vector<Eigen::Vector2d> kept;
  kept.reserve(points_m.size());
  for (const Eigen::Vector2d& point_m : points_m) {
    if (kept.empty() || (point_m - kept.back()).squaredNorm() >= spacing_m * spacing_m) {
      kept.push_back(point_m);
    }
  }
  return kept;
}

}  // namespace

ScanSlam::ScanSlam(const ScanSlamParams& params)
    : params_(params), motion_(params.motion), matcher_(params.matching), field_(params.field),
      graph_(params.graph) {}

void ScanSlam::add(const Pose2& T_odom_robot, const RangeScan& scan) {
  predict(T_odom_robot);
  std::vector<Eigen::Vector2d> points_m =
      spaced(end_points_m(scan, std::numeric_limits<double>::infinity()), params_.point_spacing_m);
  gathered_count_ += points_m.size();
  gathered_.push_back({T_odom_robot, std::move(points_m)});
  if (gathered_count_ < params_.least_points && !(key_frames_.empty())) {
    return;
  }
  std::vector<Eigen::Vector2d> all_m = gathered_points_m();
  const ScanMatch match = matcher_.match(all_m, belief_, field_);
  last_share_ = match.share;
  const Eigen::Matrix3d prior = belief_.covariance.inverse();
  Eigen::Matrix3d information = match.information;
  if (!field_.empty()) {
    belief_.T_map_robot = match.T_map_robot;
    belief_.covariance = (prior + match.information).inverse();
    information = prior + match.information;
  }
  const bool is_first = key_frames_.empty();
  const Pose2 T_key_robot =
      is_first ? Pose2() : graph_.nodes().back().inverse() * belief_.T_map_robot;
  if (is_first || T_key_robot.position_m().norm() > params_.key_frame_m ||
      std::abs(T_key_robot.heading_rad()) > params_.key_frame_rad) {
    add_key_frame(std::move(all_m), information);
  }
  const Pose2 T_robot_odom = T_odom_robot.inverse();
  const Pose2 T_key_now = graph_.nodes().back().inverse() * belief_.T_map_robot;
  for (const GatheredScan& gathered : gathered_) {
    placed_.push_back({graph_.nodes().size() - 1, T_key_now * (T_robot_odom * gathered.T_odom_robot)});
  }
  gathered_.clear();
  gathered_count_ = 0;
}

void ScanSlam::predict(const Pose2& T_odom_robot) {
  if (placed_.empty() && gathered_.empty()) {
    belief_.T_map_robot = T_odom_robot;
    belief_.covariance = 1e-8 * Eigen::Matrix3d::Identity();
    T_odom_last_ = T_odom_robot;
    return;
  }
  const Pose2 T_before_after = T_odom_last_.inverse() * T_odom_robot;
  const models::OdometryStep step = models::odometry_step(T_odom_last_, T_odom_robot);
  models::MotionSpread spread = motion_.spread(step);
  spread.drive_m = std::hypot(spread.drive_m, params_.least_spread_m);
  spread.side_m = std::hypot(spread.side_m, params_.least_spread_m);
  spread.turn_after_rad = std::hypot(spread.turn_after_rad, params_.least_spread_rad);
  belief_ = localization::moved(belief_, T_before_after, step, spread);
  T_odom_last_ = T_odom_robot;
}

std::vector<Eigen::Vector2d> ScanSlam::gathered_points_m() const {
  std::vector<Eigen::Vector2d> points_m;
  const Pose2 T_robot_odom = gathered_.back().T_odom_robot.inverse();
  for (const GatheredScan& scan : gathered_) {
    const Pose2 T_now_then = T_robot_odom * scan.T_odom_robot;
    for (const Eigen::Vector2d& point_m : scan.points_m) {
      points_m.push_back(T_now_then * point_m);
    }
  }
  return points_m;
}

void ScanSlam::add_key_frame(std::vector<Eigen::Vector2d> points_m,
                             const Eigen::Matrix3d& information) {
  const std::size_t node = graph_.add_node(belief_.T_map_robot);
  KeyFrame frame;
  frame.points_m = std::move(points_m);
  if (node > 0) {
    const Pose2 T_from_to = graph_.nodes()[node - 1].inverse() * graph_.nodes()[node];
    frame.way_m = key_frames_.back().way_m + T_from_to.position_m().norm();
    graph_.add_edge({node - 1, node, T_from_to, information, false});
  }
  key_frames_.push_back(std::move(frame));
  rebuild_field();
}

void ScanSlam::rebuild_field() {
  field_.clear();
  std::vector<Eigen::Vector2d> points_m;
  for (std::size_t i = key_frames_.size(); i-- > 0;) {
    if (key_frames_.back().way_m - key_frames_[i].way_m > params_.local_way_m) {
      break;
    }
    points_m.clear();
    for (const auto& p : key_frames_[i].points_m) {
      points_m.push_back(graph_.nodes()[i] * p);
    }
    field_.add(points_m);
  }
}

std::vector<Pose2> ScanSlam::trajectory() const {
  std::vector<Pose2> poses;
  for (const PlacedScan& scan : placed_) {
    poses.push_back(graph_.nodes()[scan.key_frame] * scan.T_key_scan);
  }
  for (const GatheredScan& scan : gathered_) {
    poses.push_back(belief_.T_map_robot * (T_odom_last_.inverse() * scan.T_odom_robot));
  }
  return poses;
}

mapping::OccupancyGrid ScanSlam::grid() const {
  mapping::OccupancyGrid grid;
  return grid;
}

}  // namespace echomap::slam
