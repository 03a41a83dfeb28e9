// SPDX-License-Identifier: MIT
#include "hil_mock/runner/robot_simulation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace echomap::runner {
namespace {

constexpr std::int64_t kStepNs = 1'000'000;
constexpr double kStepS = 1e-3;
constexpr std::int64_t kTruthPeriodNs = 20 * kStepNs;
/// HC-SR04: the burst of eight cycles and the chip's delay come between trigger and echo pin.
constexpr std::int64_t kEchoDelayNs = 460'000;

world::Polygon square(const geometry::Pose2& T_world_middle, double side_m) {
  const Eigen::Vector2d x_m(0.5 * side_m, 0.0);
  const Eigen::Vector2d y_m(0.0, 0.5 * side_m);
  world::Polygon corners_m{-x_m - y_m, x_m - y_m, x_m + y_m, -x_m + y_m};
  for (Eigen::Vector2d& corner_m : corners_m) {
    corner_m = T_world_middle * corner_m;
  }
  return corners_m;
}

}  // namespace

RobotSimulation::RobotSimulation(SimulatedBoard& board, world::RobotWorld& world)
    : board_(board),
      world_(world),
      driver_(world.robot().drive.driver, world.robot().drive.pull_downs),
      wiring_(board, world),
      pan_(world.robot().pan) {
  if (const auto& stepper = world.robot().parts.stepper) {
    stepper_.emplace(*stepper);
  }
  board_.on_sent = [this](std::uint8_t byte) {
    if (!world_.board_is_reset()) {
      sent_.push_back(byte);
    }
  };
  board_.on_trigger = [this](std::int64_t at_ns) { on_trigger(at_ns); };
  board_.on_duty = [this] { tell_duty(); };
  record_truth();
}

void RobotSimulation::advance_to(std::int64_t until_ns) {
  while (now_ns_ < until_ns) {
    const std::int64_t next_step_ns = (now_ns_ / kStepNs + 1) * kStepNs;
    now_ns_ = std::min(until_ns, next_step_ns);
    board_.run_until(now_ns_);
    if (now_ns_ == next_step_ns) {
      step_world();
    }
  }
}

void RobotSimulation::receive(std::span<const std::uint8_t> bytes) {
  last_heard_ns_ = now_ns_;
  if (!world_.board_is_reset()) {
    board_.receive(bytes);
  }
}

std::vector<std::uint8_t> RobotSimulation::take_sent() { return std::exchange(sent_, {}); }

void RobotSimulation::step_world() {
  kidnap();
  if (world_.board_is_reset()) {
    board_.reset();
  }
  const MotorDuty duty = motor_duty();
  if (duty.left != 0.0 || duty.right != 0.0) {
    last_driven_ns_ = now_ns_;
  }
  tell_duty();
  changes_.clear();
  if (before_step) {
    before_step();
  }
  world_.step(kStepS, duty, changes_);
  turn_pan();
  schedule_edges(Wheel::kLeft, changes_.left);
  schedule_edges(Wheel::kRight, changes_.right);
  const world::Contacts contacts = world_.closed_contacts();
  board_.set_bump(Wheel::kLeft, contacts.left);
  board_.set_bump(Wheel::kRight, contacts.right);
  wiring_.drive_inputs();
  if (now_ns_ % kTruthPeriodNs == 0) {
    record_truth();
  }
  if (on_step) {
    on_step();
  }
}

void RobotSimulation::tell_duty() {
  if (on_duty) {
    on_duty(board_.now_ns(), motor_duty());
  }
  if (on_driver_inputs) {
    const world::DriverInterface interface = driver_.interface();
    on_driver_inputs(board_.now_ns(),
                     board_.driver_inputs(Wheel::kLeft, interface),
                     board_.driver_inputs(Wheel::kRight, interface));
  }
}

void RobotSimulation::kidnap() {
  if (kidnaps_.empty() || now_ns_ < kidnaps_.front().lift_ns) {
    return;
  }
  world_.lift();
  if (now_ns_ >= kidnaps_.front().place_ns) {
    world_.place(kidnaps_.front().T_world_robot);
    kidnaps_.pop_front();
  }
}

world::Polygon RobotSimulation::box_at(const Eigen::Vector2d& middle_m, double side_m) const {
  return square(world_.plan().T_world_start() * geometry::Pose2(middle_m.x(), middle_m.y(), 0.0),
                side_m);
}

bool RobotSimulation::has_place_for(const world::Polygon& box_m) const {
  const auto is_clear = [&](const geometry::Pose2& T_world_robot) {
    return world_.is_clear_of(box_m, T_world_robot.position_m());
  };
  const Eigen::Vector2d middle_m = 0.5 * (box_m.front() + box_m[box_m.size() / 2]);
  return geometry::contains(world_.plan().room_m(), middle_m) && is_clear(world_.T_world_robot()) &&
         std::all_of(kidnaps_.begin(), kidnaps_.end(), [&](const Kidnap& kidnap) {
           return is_clear(kidnap.T_world_robot);
         });
}

void RobotSimulation::turn_pan() {
  if (stepper_) {
    stepper_->step(kStepS, wiring_.coils());
  } else {
    pan_.step(kStepS, board_.pan_pulse_us());
  }
}

void RobotSimulation::schedule_edges(Wheel wheel, const std::vector<world::LevelChange>& changes) {
  for (const world::LevelChange& change : changes) {
    const std::int64_t at_ns = now_ns_ + std::llround(change.at_s * 1e9);
    board_.schedule_encoder_edge(wheel, std::max(at_ns, board_.now_ns()), change.a, change.b);
  }
}

void RobotSimulation::on_trigger(std::int64_t at_ns) {
  const bool hears = world_.robot().has_sonar && !world_.sonar_is_dead();
  if (!hears || at_ns < sonar_busy_until_ns_) {
    return;
  }
  const auto flight_s = world_.ping(pan_rad());
  const std::int64_t rise_ns = at_ns + kEchoDelayNs;
  sonar_busy_until_ns_ = rise_ns + std::llround(world_.echo_pulse_s(flight_s) * 1e9);
  board_.schedule_echo(rise_ns, sonar_busy_until_ns_);
}

void RobotSimulation::record_truth() { trajectory_.push_back({now_ns_, world_.T_world_robot()}); }

}  // namespace echomap::runner
