// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "host/geometry/pose2.hpp"
#include "host/mapping/placed_reading.hpp"
#include "host/mapping/point_cloud_map.hpp"
#include "host/pipeline/slam_track.hpp"
#include "host/sensors/range_scan.hpp"
#include "host/slam/calibrated_odometry.hpp"
#include "host/slam/odometry_meter.hpp"
#include "host/slam/slam_method.hpp"
#include "host/slam/stop_alignment.hpp"

namespace echomap::pipeline {

/// SLAM of a robot that drives and pings: every ping is a scan of one beam. The method estimates
/// the path, and after each stop all stops are placed where they agree; what lies between two of
/// them moves with both. Where the first stop tells by which share of a turn odometry is off, all
/// odometry is calibrated first, that of the first stop included.
class RobotSlam {
 public:
  RobotSlam(std::unique_ptr<slam::SlamMethod> method, double beam_width_rad);

  /// The next instant of the robot's way.
  void follow(const geometry::Pose2& T_odom_robot);
  /// Between two stops: somebody has put the robot there.
  void carry(const geometry::Pose2& T_odom_robot);
  /// A ping of the last instant, of which there is one.
  void add_ping(const geometry::Pose2& T_odom_robot,
                const geometry::Pose2& T_robot_sonar,
                const std::optional<double>& range_m);
  /// A scan of the last instant, between two stops. It is not among `points`.
  void add_scan(const geometry::Pose2& T_odom_robot, const sensors::RangeScan& scan) {
    add(odometry_.T_calibrated_odom() * T_odom_robot, scan);
  }
  /// What comes now is held back until the stop's end: the robot stays where it was thought to be.
  void begin_stop();
  /// Pings of a stop that are of another place, or of a sonar that hangs, do not count.
  void end_stop(bool pings_count);

  /// From odometry to odometry without what is known of its systematic errors.
  const geometry::Pose2& T_calibrated_odom() const { return odometry_.T_calibrated_odom(); }
  /// The correction of odometry: of the method, and of the stop that was nearest when it last
  /// estimated something anew, or after it the last one.
  geometry::Pose2 T_map_odom() const {
    return T_map_slam_ * track_.T_map_odom() * odometry_.T_calibrated_odom();
  }
  /// The readings of each stop that counted, as placed after the last one: a body that turns
  /// farther than its wheels report would bend the scan of a stop that odometry places.
  std::vector<mapping::Scan> stops() const { return alignment_.scans(); }
  /// At every instant up to the last stop's end, as is known now.
  std::vector<geometry::Pose2> trajectory() const;
  /// All echoes on a trajectory of this.
  mapping::PointCloudMap points(const std::vector<geometry::Pose2>& trajectory) const;
  const slam::SlamMethod& method() const { return *method_; }

 private:
  struct Ping {
    std::size_t instant = 0;
    geometry::Pose2 T_robot_sonar;
    std::optional<double> range_m;
    slam::OdometryMark mark;  ///< Calibrated.
  };

  /// Where the alignment has the robot at an instant, and the method.
  struct Anchor {
    std::size_t instant = 0;
    geometry::Pose2 T_map_robot;
    geometry::Pose2 T_slam_robot;

    geometry::Pose2 T_map_slam() const { return T_map_robot * T_slam_robot.inverse(); }
  };

  /// Learns of the first stop by which share of a turn odometry is off, and places it anew.
  void calibrate_by_stop(std::size_t first_ping);
  std::vector<slam::StopReading> readings_from(std::size_t first_ping) const;
  void count(const Ping& ping);
  void add(const geometry::Pose2& T_calibrated_robot, const sensors::RangeScan& scan);
  void align_stops(std::size_t first_ping);
  /// Poses of these pings by the method alone.
  std::vector<geometry::Pose2> T_slam_robots(const std::vector<std::size_t>& pings) const;
  /// The anchor nearest to a pose of the method, the last one of several: the method's map and that
  /// of the aligned stops are bent differently.
  Anchor nearest_to(const geometry::Pose2& T_slam_robot) const;
  void correct_by(const Anchor& anchor);
  /// The first and the last reading at rest of each stand, in the order of time.
  std::vector<Anchor> anchors() const;

  std::unique_ptr<slam::SlamMethod> method_;
  SlamTrack track_;
  double beam_width_rad_;
  std::vector<Ping> pings_;
  bool is_at_stop_ = false;
  std::vector<geometry::Pose2> held_T_calibrated_robots_;
  std::size_t held_pings_ = 0;  ///< The last ones of all.
  slam::CalibratedOdometry odometry_;
  slam::OdometryMeter meter_;  ///< Of what is calibrated.
  /// As they were when the stop began.
  slam::CalibratedOdometry odometry_before_;
  slam::OdometryMeter meter_before_;
  slam::StopAlignment alignment_;
  std::vector<std::size_t> first_pings_;  ///< Of each stop of the alignment.
  /// From the method's map to that of the aligned stops, where the robot is, and the method's
  /// correction of odometry at that time.
  geometry::Pose2 T_map_slam_;
  geometry::Pose2 T_slam_odom_;
};

}  // namespace echomap::pipeline
