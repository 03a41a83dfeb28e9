// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "hil_mock/world/robot_world.hpp"
#include "host/evaluation/trajectory_error.hpp"
#include "host/exploration/explorer.hpp"
#include "host/pipeline/observation_sink.hpp"
#include "host/sensors/odometry.hpp"
#include "host/sensors/robot_geometry.hpp"

namespace echomap::tests {

/// What the host believes of a simulated robot: its nominal sizes.
sensors::RobotGeometry assumed_geometry(const world::RobotParams& robot);

/// Somebody takes the robot and puts it down there at once, which it feels or not.
struct OfflineCarry {
  double at_s = 0.0;
  geometry::Pose2 T_world_robot;
  bool is_felt = false;
};

/// A simulated robot that carries out motions without board or link: wheels by a plain controller,
/// readings straight from the world. Times are simulated and only roughly those of a real robot.
class OfflineRobot {
 public:
  /// All three outlive this.
  OfflineRobot(world::RobotWorld& world,
               const sensors::RobotGeometry& geometry,
               pipeline::ObservationSink& sink,
               std::vector<OfflineCarry> carries = {});

  exploration::MotionResult execute(const exploration::Motion& motion);
  /// From now on the sonar looks around whenever the wheels turn, as that of session::RobotSession.
  void look_around_on_the_way() { looks_on_the_way_ = true; }

  /// Where the robot was at every observation that the sink has had, truly and by odometry
  /// alone.
  const std::vector<evaluation::TruePose>& true_path() const { return true_path_; }
  const std::vector<pipeline::StampedPose>& odometry_path() const { return odometry_path_; }
  double now_s() const { return static_cast<double>(now_us_) * 1e-6; }

 private:
  exploration::MotionResult move(const sensors::WheelTicks& ticks);
  exploration::MotionResult roll(const exploration::Roll& roll);
  exploration::MotionResult stand(const exploration::Stand& stand);
  bool is_touching() const;
  exploration::MotionResult sweep(const exploration::Sweep& sweep);
  sensors::WheelTravel travel() const;
  time::RobotTime stamp() const { return time::RobotTime(time::RobotClock::duration(now_us_)); }
  void look_around();
  void ping(double pan_rad);
  void step(const world::WheelDuty& duty);
  void keep_path();
  /// The first of those that are planned, once it is due.
  void carry_off();

  world::RobotWorld& world_;
  sensors::RobotGeometry geometry_;
  pipeline::ObservationSink& sink_;
  std::vector<OfflineCarry> carries_;
  world::EncoderChanges changes_;
  bool looks_on_the_way_ = false;
  std::int64_t next_look_us_ = 0;
  double look_pan_rad_ = 0.0;
  double look_step_rad_ = 0.26;
  std::int64_t now_us_ = 0;
  sensors::WheelOdometry odometry_;
  std::vector<evaluation::TruePose> true_path_;
  std::vector<pipeline::StampedPose> odometry_path_;
};

}  // namespace echomap::tests
