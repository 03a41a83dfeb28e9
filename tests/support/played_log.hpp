// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "host/pipeline/log_player.hpp"
#include "host/pipeline/slam_track.hpp"
#include "host/slam/slam_method.hpp"

namespace echomap::tests {

/// Plays all of them.
inline pipeline::LogCounts play(const std::vector<datasets::LogRecord>& records,
                                pipeline::ObservationSink& sink,
                                pipeline::PoseSource source = pipeline::PoseSource::kOdometry) {
  pipeline::LogPlayer player(sink, source);
  for (const datasets::LogRecord& record : records) {
    player.play(record);
  }
  return player.counts();
}

/// Hears what a log tells of odometry and range scans.
class OdometrySink : public pipeline::ObservationSink {
 public:
  void on_odometry(const sensors::OdometryObservation& /*is_of_our_robots*/) override {}
  void on_sonar(const sensors::SonarObservation& /*is_of_our_robots*/) override {}
  void begin_scan() override {}
  void end_scan() override {}
  void on_odometry_pose(const sensors::OdometryPoseObservation& observation) override {
    T_odom_robots.push_back(observation.T_odom_robot);
  }

  std::vector<geometry::Pose2> T_odom_robots;
};

/// Hands the odometry and the scans of a log to a SLAM method, as RobotPipeline does.
class SlamSink final : public OdometrySink {
 public:
  explicit SlamSink(slam::SlamMethod& method) : track_(method) {}

  void on_odometry_pose(const sensors::OdometryPoseObservation& observation) override {
    OdometrySink::on_odometry_pose(observation);
    track_.follow(observation.T_odom_robot);
  }
  void on_range_scan(const sensors::RangeScan& scan) override {
    track_.add(T_odom_robots.back(), scan);
  }

  const pipeline::SlamTrack& track() const { return track_; }

 private:
  pipeline::SlamTrack track_;
};

}  // namespace echomap::tests
