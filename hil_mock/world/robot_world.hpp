// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "hil_mock/world/floor_plan.hpp"
#include "hil_mock/world/noise.hpp"
#include "hil_mock/world/part_faults.hpp"
#include "hil_mock/world/person.hpp"
#include "hil_mock/world/robot_body.hpp"
#include "hil_mock/world/robot_params.hpp"
#include "hil_mock/world/robot_parts.hpp"
#include "hil_mock/world/sonar_physics.hpp"

namespace echomap::world {

/// A robot's body and sensors in a room, without any board: what happens is a function of the seed
/// and of the calls made.
class RobotWorld {
 public:
  /// Throws std::invalid_argument where robot or start do not fit.
  /// A fault of a part that the robot has not is refused in the same way.
  RobotWorld(FloorPlan plan,
             const RobotParams& robot,
             std::uint32_t seed,
             std::vector<PartFault> faults = {});
  RobotWorld(const RobotWorld&) = delete;
  RobotWorld& operator=(const RobotWorld&) = delete;

  /// Moves for `dt_s` (a millisecond is fine enough) and appends what the encoders do.
  void step(double dt_s, const WheelDuty& duty, EncoderChanges& changes);

  /// Where the hulls of the other robots in the room are from now on: they send sound and light
  /// back, stop the body and press its bumpers. To be told before every step in which one has
  /// moved; robots that step in turn, each told of the others' newest places, never overlap.
  void set_peers(std::span<const Disc> peers) { plan_.put_robots(peers); }
  /// This robot, as the others meet it; empty while somebody holds it.
  std::optional<Disc> hull() const;

  /// One ping at the present pose: the echo's time of flight, there and back, in seconds; empty
  /// where nothing answered.
  std::optional<double> ping(double pan_rad);
  /// Whether the sonar does not even say that nothing has answered.
  bool sonar_is_dead() const { return fault(PartFaultKind::kSonarDead).has_value(); }
  /// How long the echo pin is high for a flight that `ping` has told.
  double echo_pulse_s(std::optional<double> flight_s) const;
  /// Whether the board is held in its boot loader.
  bool board_is_reset() const { return fault(PartFaultKind::kBoardReset).has_value(); }

  /// Takes the robot off the floor, until it is placed.
  void lift() { body_.lift(); }
  /// Puts the robot down elsewhere.
  void place(const geometry::Pose2& T_world_robot);
  /// Whether the robot has room there, with so much between its hull and walls and other robots.
  bool fits(const Eigen::Vector2d& place_m, double clearance_m) const;
  /// A place with room for the robot, a metre and more from here, looking anywhere: where somebody
  /// who carries it off may put it down. In a room without one, the farthest of a thousand others.
  geometry::Pose2 somewhere_else();

  /// Whether the robot, standing at a place, would have a hand's breadth between its hull and that
  /// box.
  bool is_clear_of(const Polygon& box_m, const Eigen::Vector2d& place_m) const;
  /// From now on a box of cardboard stands there: walls see to it that the robot does not pass.
  void put_box(const Polygon& box_m) { plan_.put_box({box_m, {}, 0.0}); }

  const geometry::Pose2& T_world_robot() const { return body_.T_world_robot(); }
  /// Where the robot is, seen from where it started: as a map of its host has it.
  geometry::Pose2 T_start_robot() const {
    return plan_.T_world_start().inverse() * T_world_robot();
  }
  geometry::Pose2 T_world_sonar(double pan_rad) const;
  /// Those that touch something.
  Contacts contacts() const { return body_.contacts(); }
  /// Those that are closed, as the board finds them.
  Contacts closed_contacts() const;
  const RobotBody& body() const { return body_; }
  RobotParts& parts() { return parts_; }
  const FloorPlan& plan() const { return plan_; }
  const RobotParams& robot() const { return robot_; }

 private:
  std::optional<double> fault(PartFaultKind kind) const { return fault_at(faults_, kind, now_s_); }
  bool has_fault(PartFaultKind kind) const { return fault(kind).has_value(); }
  void move_people(double dt_s);
  void apply_body_faults();
  /// What reaches the motors of what the board puts out.
  WheelDuty wired(WheelDuty duty) const;
  /// What reaches the board of what the encoders do.
  void wire(EncoderChanges& changes) const;
  /// Takes the dirty encoder's share of the edges from the first one on out: each comes with the
  /// next.
  void soil(PartFaultKind dirt, std::size_t first, std::vector<LevelChange>& wheel);

  FloorPlan plan_;
  RobotParams robot_;
  RobotBody body_;
  SonarPhysics sonar_;
  NoiseStream sonar_noise_;
  NoiseStream places_;
  NoiseStream dirt_;
  RobotParts parts_;
  std::vector<PartFault> faults_;
  std::vector<Person> people_;
  double now_s_ = 0.0;
};

}  // namespace echomap::world
