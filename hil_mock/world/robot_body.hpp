// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "hil_mock/world/collision_counter.hpp"
#include "hil_mock/world/contact_physics.hpp"
#include "hil_mock/world/floor_contact.hpp"
#include "hil_mock/world/floor_plan.hpp"
#include "hil_mock/world/motor_driver.hpp"
#include "hil_mock/world/noise.hpp"
#include "hil_mock/world/robot_params.hpp"
#include "hil_mock/world/wheel_drive.hpp"
#include "host/geometry/pose2.hpp"

namespace echomap::world {

/// How far the wheels move the robot, as a share of what their parameters say: less on a wet spot,
/// more where a wheel is larger.
struct WheelRolling {
  double left = 1.0;
  double right = 1.0;
};

/// The encoders' changes during one step, each wheel's in order of time.
struct EncoderChanges {
  std::vector<LevelChange> left;
  std::vector<LevelChange> right;

  void clear();
};

/// A differential-drive body in a room. Its wheels and track are not quite what the profile says,
/// its tyres slip, and walls stop it while its wheels go on turning. With a wheel over a hole it
/// lies on its belly and is stuck.
class RobotBody {
 public:
  /// Draws this run's errors of wheels, track and motors. `plan` must outlive this. Throws
  /// std::invalid_argument for sizes that are not positive or where the body does not fit.
  RobotBody(const FloorPlan& plan,
            const DriveParams& drive,
            const BodyParams& body,
            NoiseStream noise);

  /// Moves for `dt_s` and appends what the encoders do in that time.
  void step(double dt_s, const WheelDuty& duty, EncoderChanges& changes);

  /// From now on.
  void scale_rolling(const WheelRolling& rolling) { rolling_ = rolling; }
  /// From now on both encoders give so many times the edges of their parameters.
  void scale_counts(double scale);

  /// Takes the robot off the floor: its wheels turn freely until it is placed.
  void lift() { lifted_ = true; }
  bool is_lifted() const { return lifted_; }
  /// Puts the robot down elsewhere.
  void place(const geometry::Pose2& T_world_robot);

  /// Frame of the robot: origin in the middle of the axle, x forward, y left.
  const geometry::Pose2& T_world_robot() const { return T_world_robot_; }
  Contacts contacts() const;
  /// With walls, since the beginning.
  const Collisions& collisions() const { return collisions_.collisions(); }
  /// Which wheels stand on the floor.
  WheelSupport support() const;
  const WheelDrive& left_wheel() const { return left_; }
  const WheelDrive& right_wheel() const { return right_; }

 private:
  struct Errors;
  RobotBody(const FloorPlan& plan,
            const DriveParams& drive,
            const BodyParams& body,
            const Errors& errors,
            NoiseStream noise);
  static Errors draw_errors(const DriveParams& drive, NoiseStream& noise);
  double slipped(double rolled_m);
  void roll(double left_m, double right_m);

  const FloorPlan& plan_;
  BodyParams body_;
  double slip_m_per_sqrt_m_;
  double track_m_;
  WheelDrive left_;
  WheelDrive right_;
  WheelRolling rolling_;
  NoiseStream noise_;
  geometry::Pose2 T_world_robot_;
  bool lifted_ = false;
  CollisionCounter collisions_;
};

}  // namespace echomap::world
