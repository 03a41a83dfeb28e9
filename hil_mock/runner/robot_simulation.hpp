// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "hil_mock/runner/aux_wiring.hpp"
#include "hil_mock/runner/simulated_board.hpp"
#include "hil_mock/world/pan_servo.hpp"
#include "hil_mock/world/robot_world.hpp"
#include "hil_mock/world/stepper_motor.hpp"
#include "host/geometry/pose2.hpp"

namespace echomap::runner {

/// Where the robot truly was.
struct TruthSample {
  std::int64_t at_ns = 0;
  geometry::Pose2 T_world_robot;
};

/// Somebody lifts the robot, holds it and puts it down elsewhere.
struct Kidnap {
  std::int64_t lift_ns = 0;
  std::int64_t place_ns = 0;
  geometry::Pose2 T_world_robot;
};

/// A board in a world: its motors move the body, the body turns its encoders and presses its
/// bumpers, its pings meet the room's walls. Physics goes in steps of a millisecond; an encoder
/// edge reaches its pin one step after it happened, at its exact place within the step.
class RobotSimulation {
 public:
  /// Both must outlive this; takes the board's hooks. Throws files::ConfigError where the robot is
  /// not wired for this board.
  RobotSimulation(SimulatedBoard& board, world::RobotWorld& world);
  RobotSimulation(const RobotSimulation&) = delete;
  RobotSimulation& operator=(const RobotSimulation&) = delete;

  /// Runs board and world up to `until_ns` of simulated time; does nothing where that is past.
  void advance_to(std::int64_t until_ns);

  /// Plans a kidnap, after those that are planned already.
  void schedule(const Kidnap& kidnap) { kidnaps_.push_back(kidnap); }
  /// Somebody lifts the robot now, holds it for so long and puts it down somewhere else.
  void carry_off(std::int64_t held_ns) {
    schedule({now_ns_, now_ns_ + held_ns, world_.somewhere_else()});
  }

  /// A square box, in the world: parallel to the axes of the robot's start pose and with its middle
  /// at a point in that frame.
  world::Polygon box_at(const Eigen::Vector2d& middle_m, double side_m) const;
  /// False where its middle is not in the room or it would be in the way of the robot or of a hand
  /// that puts the robot down.
  bool has_place_for(const world::Polygon& box_m) const;
  /// From now on that box stands there.
  void put_box(const world::Polygon& box_m) { world_.put_box(box_m); }

  /// Where the other robots are from now on.
  void set_peers(std::span<const world::Disc> peers) { world_.set_peers(peers); }

  /// Called before every millisecond of the world.
  std::function<void()> before_step;
  /// Called after every millisecond of the world.
  std::function<void()> on_step;
  /// Called with the board's time and what its motors get: every millisecond, and between at the
  /// instants at which the program may have changed it.
  std::function<void(std::int64_t now_ns, const MotorDuty& duty)> on_duty;
  /// At the same instants, what both drivers' inputs get.
  std::function<void(
      std::int64_t now_ns, const world::DriverInputs& left, const world::DriverInputs& right)>
      on_driver_inputs;

  /// Bytes for the board's receive line.
  void receive(std::span<const std::uint8_t> bytes);
  /// Bytes that the board has sent since the last call.
  std::vector<std::uint8_t> take_sent();

  std::int64_t now_ns() const { return now_ns_; }
  /// What the robot's drivers give its motors now.
  MotorDuty motor_duty() const { return board_.motor_duty(driver_); }
  /// When bytes last came for the board, and the end of the last step in which it drove a motor; 0
  /// for never.
  std::int64_t last_heard_ns() const { return last_heard_ns_; }
  std::int64_t last_driven_ns() const { return last_driven_ns_; }
  /// The truth at 50 Hz, from time 0 on.
  const std::vector<TruthSample>& trajectory() const { return trajectory_; }
  const SimulatedBoard& board() const { return board_; }
  const world::RobotWorld& world() const { return world_; }
  /// Where the sonar looks, counter-clockwise from straight ahead; a stepper may turn it beyond a
  /// whole turn.
  double pan_rad() const { return stepper_ ? stepper_->pan_rad() : pan_.pan_rad(); }

 private:
  void tell_duty();
  void step_world();
  void kidnap();
  void turn_pan();
  void schedule_edges(Wheel wheel, const std::vector<world::LevelChange>& changes);
  void on_trigger(std::int64_t at_ns);
  void record_truth();

  SimulatedBoard& board_;
  world::RobotWorld& world_;
  world::MotorDriver driver_;
  AuxWiring wiring_;
  world::PanServo pan_;
  std::optional<world::StepperMotor> stepper_;
  std::deque<Kidnap> kidnaps_;
  world::EncoderChanges changes_;
  std::vector<std::uint8_t> sent_;
  std::vector<TruthSample> trajectory_;
  std::int64_t now_ns_ = 0;
  std::int64_t last_heard_ns_ = 0;
  std::int64_t last_driven_ns_ = 0;
  std::int64_t sonar_busy_until_ns_ = 0;
};

}  // namespace echomap::runner
