// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "host/mapping/near_mapper.hpp"
#include "host/mapping/occupancy_grid.hpp"
#include "host/mapping/point_cloud_map.hpp"
#include "host/mapping/sonar_mapper.hpp"
#include "host/pipeline/observation_sink.hpp"
#include "host/pipeline/robot_slam.hpp"
#include "host/pipeline/snapshot.hpp"
#include "host/sensors/observations.hpp"
#include "host/sensors/odometry.hpp"
#include "host/sensors/robot_geometry.hpp"
#include "host/slam/slam_method.hpp"

namespace echomap::pipeline {

/// Observations in, snapshots out: the same object live and in replay, a function of its input
/// alone. Feed observations in the order of their stamps. Between stops the pose is odometry, or
/// that of SLAM; at the end of a scan it is moved to where the scan agrees with those before it,
/// and what SLAM has learnt of the way so far moves it as well as all scans. What the robot feels
/// on its way goes into the grid at once, until somebody lifts it, and stays there.
class RobotPipeline final : public ObservationSink {
 public:
  explicit RobotPipeline(const sensors::RobotGeometry& robot,
                         const mapping::SonarMapperParams& params = {},
                         const mapping::NearMapperParams& near = {},
                         std::unique_ptr<slam::SlamMethod> slam = nullptr);

  void on_odometry(const sensors::OdometryObservation& observation) override;
  /// Places the reading by its own wheel travel. Its echo is a point of the map at once; the grid
  /// only takes readings of a scan.
  void on_sonar(const sensors::SonarObservation& observation) override;

  /// The last of each stands in the snapshot; a wheel that begins to hang counts as a lift.
  void on_hazards(const sensors::HazardObservation& observation) override;
  /// Placed by its own wheel travel.
  void on_infrared(const sensors::InfraredObservation& observation) override;
  /// The pose is known again; what is in the map stays where it is. Ends a scan that is open.
  void on_carried(const sensors::CarriedObservation& observation) override;
  /// The robot is there; its odometry continues from there.
  void on_pose_fix(const sensors::PoseFixObservation& observation) override;
  void on_yaw(const sensors::YawObservation& observation) override { yaw_ = observation; }
  void on_battery(const sensors::BatteryObservation& observation) override {
    battery_ = observation;
  }

  void begin_scan() override;
  /// Puts the scan's readings into the grid together, unless they are of a sonar that hangs or of
  /// another place.
  void end_scan() override;

  Snapshot snapshot() const;
  /// Null without SLAM.
  const slam::SlamMethod* slam() const { return slam_ ? &slam_->method() : nullptr; }

 private:
  /// The pose by odometry alone, after the wheels' travel so far.
  geometry::Pose2 follow(time::RobotTime stamp, const sensors::WheelTravel& travel);
  /// Moves what odometry has placed to where it is on the map.
  mapping::PlacedReading on_map(const mapping::PlacedReading& reading) const {
    return mapping::moved(reading, T_map_odom());
  }
  mapping::Scan on_map(const mapping::Scan& scan) const {
    return mapping::moved(scan, T_map_odom());
  }
  /// Puts the open scan into the map.
  void map_scan();
  /// Moves trajectory and points to where SLAM has them now.
  void move_past();
  /// Where odometry has the robot, on the map.
  geometry::Pose2 T_map_robot() const { return T_map_odom() * odometry_.T_odom_robot(); }
  geometry::Pose2 T_map_odom() const;

  std::shared_ptr<const mapping::OccupancyGrid> grid() const;

  sensors::RobotGeometry robot_;
  mapping::SonarMapper mapper_;
  mapping::NearMapper near_;
  sensors::WheelOdometry odometry_;
  std::optional<RobotSlam> slam_;
  geometry::Pose2 T_map_mapped_;  ///< What somebody who sees the robot adds to what it knows.
  std::shared_ptr<std::vector<StampedPose>> trajectory_ =
      std::make_shared<std::vector<StampedPose>>();
  std::vector<std::size_t> carried_to_;  ///< Indices of the trajectory.
  std::shared_ptr<mapping::PointCloudMap> points_ = std::make_shared<mapping::PointCloudMap>();
  std::shared_ptr<const mapping::OccupancyGrid> far_grid_;
  /// Both together, made when a snapshot asks for it after one of them has changed.
  mutable std::shared_ptr<const mapping::OccupancyGrid> grid_;
  mutable std::uint64_t near_in_grid_ = 0;
  std::vector<mapping::Scan>
      placed_scans_;  ///< Those in the grid, as odometry or SLAM places them.
  std::shared_ptr<const std::vector<mapping::Scan>> scans_;
  std::shared_ptr<const mapping::Scan> last_scan_;
  mapping::Scan open_scan_;
  bool scan_is_open_ = false;
  mapping::ScanFault last_scan_fault_ = mapping::ScanFault::kNone;
  std::size_t stops_ = 0;
  double newly_free_m2_ = 0.0;
  sensors::HazardObservation hazards_;
  sensors::InfraredObservation infrared_;
  std::optional<sensors::YawObservation> yaw_;
  std::optional<sensors::BatteryObservation> battery_;
  std::size_t times_lifted_ = 0;
};

}  // namespace echomap::pipeline
