// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "hil_mock/world/robot_world.hpp"
#include "host/evaluation/trajectory_error.hpp"
#include "host/exploration/explorer.hpp"
#include "host/pipeline/robot_pipeline.hpp"
#include "host/sensors/odometry.hpp"
#include "host/sensors/robot_geometry.hpp"

namespace echomap::tests {

/// What the host believes of a simulated robot: its nominal sizes.
sensors::RobotGeometry believed_geometry(const world::RobotParams& robot);

/// A simulated robot that carries out motions without board or link: wheels by a plain controller,
/// readings straight from the world. Times are simulated and only roughly those of a real robot.
class OfflineRobot {
 public:
  /// All three outlive this.
  OfflineRobot(world::RobotWorld& world,
               const sensors::RobotGeometry& geometry,
               pipeline::RobotPipeline& pipeline);

  exploration::MotionResult execute(const exploration::Motion& motion);

  /// Where the robot was at every observation that the pipeline has had, truly and by odometry
  /// alone.
  const std::vector<evaluation::TruePose>& true_path() const { return true_path_; }
  const std::vector<pipeline::StampedPose>& odometry_path() const { return odometry_path_; }
  double now_s() const { return static_cast<double>(now_us_) * 1e-6; }

 private:
  exploration::MotionResult move(const sensors::WheelTicks& ticks);
  exploration::MotionResult roll(const exploration::Roll& roll);
  bool is_touching() const;
  exploration::MotionResult sweep(const exploration::Sweep& sweep);
  sensors::WheelTravel travel() const;
  time::RobotTime stamp() const { return time::RobotTime(time::RobotClock::duration(now_us_)); }
  void step(const world::WheelDuty& duty);
  void keep_path();

  world::RobotWorld& world_;
  sensors::RobotGeometry geometry_;
  pipeline::RobotPipeline& pipeline_;
  world::EncoderChanges changes_;
  std::int64_t now_us_ = 0;
  sensors::WheelOdometry odometry_;
  std::vector<evaluation::TruePose> true_path_;
  std::vector<pipeline::StampedPose> odometry_path_;
};

}  // namespace echomap::tests
