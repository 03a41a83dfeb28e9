// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include "host/mapping/contact_mapper.hpp"
#include "host/mapping/placed_reading.hpp"
#include "host/mapping/sonar_mapper.hpp"
#include "host/pipeline/observation_sink.hpp"
#include "host/pipeline/pose_track.hpp"
#include "host/pipeline/robot_status.hpp"
#include "host/pipeline/scan_map.hpp"
#include "host/pipeline/snapshot.hpp"
#include "host/pipeline/stop_map.hpp"
#include "host/sensors/observations.hpp"
#include "host/sensors/range_scan.hpp"
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
                         const mapping::ContactMapperParams& near = {},
                         std::unique_ptr<slam::SlamMethod> slam = nullptr,
                         const ScanMapParams& scans = {});

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
  void on_yaw(const sensors::YawObservation& observation) override { status_.on_yaw(observation); }
  void on_battery(const sensors::BatteryObservation& observation) override {
    status_.on_battery(observation);
  }

  void on_odometry_pose(const sensors::OdometryPoseObservation& observation) override;
  /// Goes into the map from where the robot is; with SLAM, from where that has it in the end.
  void on_range_scan(const sensors::RangeScan& scan) override;
  void on_landmark(const sensors::LandmarkObservation& observation) override;

  void begin_scan() override;
  /// Puts the scan's readings into the grid together, unless they are of a sonar that hangs or of
  /// another place.
  void end_scan() override;

  Snapshot snapshot() const;
  /// A small part of it, at once.
  PoseEstimate pose_estimate() const { return track_.estimate(); }
  /// Null without SLAM.
  const slam::SlamMethod* slam() const {
    return track_.slam() != nullptr ? &track_.slam()->method() : nullptr;
  }
  /// What SLAM has estimated, on the map. Throws std::logic_error without SLAM.
  slam::FactorGraph factor_graph() const;

 private:
  /// What was seen from a pose of the trajectory.
  struct Sighting {
    std::size_t pose_index = 0;
    std::variant<sensors::RangeScan, sensors::LandmarkObservation> seen;
  };

  void pass_over_floor();
  /// Where the robot has not told its pose yet, it is at the origin.
  template <class Seen>
  void add_sighting(const Seen& seen);
  geometry::Pose2 T_calibrated_odom() const;
  void describe_scans(Snapshot& snapshot) const;

  sensors::RobotGeometry robot_;
  PoseTrack track_;
  StopMap map_;
  ScanMapParams scan_params_;
  ScanMap scan_map_;
  std::vector<Sighting> sightings_;  ///< With SLAM, in place of `scan_map_`.
  RobotStatus status_;
  std::optional<mapping::Scan> open_scan_;  ///< As calibrated odometry places it.
};

}  // namespace echomap::pipeline
