// SPDX-License-Identifier: MIT
#include "tests/support/offline_robot.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

namespace echomap::tests {

namespace {

using exploration::MotionResult;

constexpr std::int64_t kStepUs = 1000;
constexpr std::int64_t kOdometryPeriodUs = 20'000;
constexpr std::int64_t kLongestMoveUs = 60'000'000;
constexpr int kSettleSteps = 300;
constexpr double kFastestDuty = 0.5;
constexpr double kSlowestDuty = 0.15;
constexpr double kDutyPerTick = 0.0015;
constexpr double kDutyPerTickApart = 0.002;
constexpr double kCloseTicks = 2.0;
/// A look on the way: 15 degrees on, at rest, and an echo from 4 m.
constexpr std::int64_t kLookPeriodUs = 110'000;
constexpr double kMaxLookRad = 1.571;

/// Faster the farther it is to go; stands when it is there.
double duty_for(double ticks_to_go) {
  if (std::abs(ticks_to_go) < kCloseTicks) {
    return 0.0;
  }
  const double duty =
      std::clamp(kSlowestDuty + kDutyPerTick * std::abs(ticks_to_go), 0.0, kFastestDuty);
  return std::copysign(duty, ticks_to_go);
}

}  // namespace

sensors::RobotGeometry assumed_geometry(const world::RobotParams& robot) {
  sensors::RobotGeometry geometry;
  geometry.wheel_diameter_m = robot.drive.wheel_diameter_m;
  geometry.track_m = robot.drive.track_m;
  geometry.counts_per_turn = robot.drive.counts_per_turn;
  geometry.sonar_x_m = robot.sonar.mount_x_m;
  geometry.sonar_y_m = robot.sonar.mount_y_m;
  return geometry;
}

OfflineRobot::OfflineRobot(world::RobotWorld& world,
                           const sensors::RobotGeometry& geometry,
                           pipeline::ObservationSink& sink,
                           std::vector<OfflineCarry> carries)
    : world_(world),
      geometry_(geometry),
      sink_(sink),
      carries_(std::move(carries)),
      odometry_(geometry.track_m) {}

MotionResult OfflineRobot::execute(const exploration::Motion& motion) {
  if (const auto* turn = std::get_if<exploration::Turn>(&motion)) {
    return move(geometry_.turn_on_spot(turn->angle_rad));
  }
  if (const auto* drive = std::get_if<exploration::Drive>(&motion)) {
    return move(geometry_.straight(drive->distance_m));
  }
  if (const auto* arc = std::get_if<exploration::Roll>(&motion)) {
    return roll(*arc);
  }
  if (const auto* sweep_motion = std::get_if<exploration::Sweep>(&motion)) {
    return sweep(*sweep_motion);
  }
  if (const auto* rest = std::get_if<exploration::Stand>(&motion)) {
    return stand(*rest);
  }
  if (std::holds_alternative<exploration::BeginScan>(motion)) {
    sink_.begin_scan();
  } else if (std::holds_alternative<exploration::EndScan>(motion)) {
    sink_.end_scan();
  }
  return MotionResult::kReached;
}

MotionResult OfflineRobot::move(const sensors::WheelTicks& ticks) {
  const double left_goal = static_cast<double>(world_.body().left_wheel().counts()) + ticks.left;
  const double right_goal = static_cast<double>(world_.body().right_wheel().counts()) + ticks.right;
  const bool forward = ticks.left + ticks.right > 0;
  int steps_at_rest = 0;
  for (const std::int64_t end_us = now_us_ + kLongestMoveUs; now_us_ < end_us;) {
    const double left = left_goal - static_cast<double>(world_.body().left_wheel().counts());
    const double right = right_goal - static_cast<double>(world_.body().right_wheel().counts());
    const double apart = std::abs(left) - std::abs(right);
    world::WheelDuty duty{duty_for(left), duty_for(right)};
    duty.left *= 1.0 + kDutyPerTickApart * apart;
    duty.right *= 1.0 - kDutyPerTickApart * apart;
    const bool bumped = forward && is_touching();
    step(bumped ? world::WheelDuty{} : duty);
    const bool at_rest = bumped || (duty.left == 0.0 && duty.right == 0.0);
    steps_at_rest = at_rest ? steps_at_rest + 1 : 0;
    if (steps_at_rest > kSettleSteps) {
      return bumped ? MotionResult::kBumped : MotionResult::kReached;
    }
  }
  return MotionResult::kTimedOut;
}

MotionResult OfflineRobot::roll(const exploration::Roll& roll) {
  const auto& drive = world_.robot().drive;
  const auto duty_of = [&](double speed_m_per_s) {
    const double share = std::abs(speed_m_per_s) / drive.no_load_speed_m_per_s;
    const double duty = share * (1.0 - drive.dead_zone_duty) + drive.dead_zone_duty;
    return speed_m_per_s == 0.0 ? 0.0 : std::copysign(std::min(duty, 1.0), speed_m_per_s);
  };
  const double apart_m_per_s = roll.turn_rad_per_s * geometry_.track_m / 2.0;
  const world::WheelDuty duty{duty_of(roll.forward_m_per_s - apart_m_per_s),
                              duty_of(roll.forward_m_per_s + apart_m_per_s)};
  const bool was_touching = is_touching();
  for (const std::int64_t end_us = now_us_ + std::llround(roll.for_s * 1e6); now_us_ < end_us;) {
    step(is_touching() && roll.forward_m_per_s > 0.0 ? world::WheelDuty{} : duty);
    if (is_touching() && !was_touching) {
      return MotionResult::kBumped;
    }
  }
  return MotionResult::kReached;
}

MotionResult OfflineRobot::stand(const exploration::Stand& stand) {
  for (const std::int64_t end_us = now_us_ + std::llround(stand.for_s * 1e6); now_us_ < end_us;) {
    step({});
  }
  return MotionResult::kReached;
}

bool OfflineRobot::is_touching() const {
  const auto contacts = world_.contacts();
  return contacts.left || contacts.right;
}

MotionResult OfflineRobot::sweep(const exploration::Sweep& sweep) {
  const auto readings =
      static_cast<int>(std::lround((sweep.to_rad - sweep.from_rad) / sweep.step_rad)) + 1;
  for (int i = 0; i < readings; ++i) {
    const double pan_rad = sweep.from_rad + i * sweep.step_rad;
    constexpr double kServoAndPingS = 0.06;
    now_us_ += std::llround((sweep.settle_s + kServoAndPingS) * 1e6);
    ping(pan_rad);
    carry_off();
  }
  return MotionResult::kReached;
}

void OfflineRobot::look_around() {
  if (now_us_ < next_look_us_) {
    return;
  }
  next_look_us_ = now_us_ + kLookPeriodUs;
  look_pan_rad_ += look_step_rad_;
  if (std::abs(look_pan_rad_) > kMaxLookRad) {
    look_step_rad_ = -look_step_rad_;
    look_pan_rad_ += look_step_rad_;
  }
  ping(look_pan_rad_);
}

void OfflineRobot::ping(double pan_rad) {
  sensors::SonarObservation observation{stamp(), travel(), pan_rad, std::nullopt};
  if (const auto flight_s = world_.ping(pan_rad)) {
    observation.range_m = *flight_s * world_.robot().sonar.speed_of_sound_m_per_s / 2.0;
  }
  sink_.on_sonar(observation);
  keep_path();
}

sensors::WheelTravel OfflineRobot::travel() const {
  const double metres_per_tick = geometry_.metres_per_tick();
  return {static_cast<double>(world_.body().left_wheel().counts()) * metres_per_tick,
          static_cast<double>(world_.body().right_wheel().counts()) * metres_per_tick};
}

void OfflineRobot::step(const world::WheelDuty& duty) {
  changes_.clear();
  world_.step(static_cast<double>(kStepUs) * 1e-6, duty, changes_);
  now_us_ += kStepUs;
  if (looks_on_the_way_ && (duty.left != 0.0 || duty.right != 0.0)) {
    look_around();
  }
  if (now_us_ % kOdometryPeriodUs == 0) {
    const auto contacts = world_.contacts();
    sink_.on_odometry({stamp(), travel()});
    keep_path();
    sensors::HazardObservation hazards;
    hazards.stamp = stamp();
    hazards.bump_left = contacts.left;
    hazards.bump_right = contacts.right;
    sink_.on_hazards(hazards);
    carry_off();
  }
}

void OfflineRobot::carry_off() {
  if (carries_.empty() || now_s() < carries_.front().at_s) {
    return;
  }
  if (carries_.front().is_felt) {
    sensors::HazardObservation hazards;
    hazards.stamp = stamp();
    hazards.lifted = true;
    sink_.on_hazards(hazards);
  }
  world_.place(carries_.front().T_world_robot);
  carries_.erase(carries_.begin());
}

void OfflineRobot::keep_path() {
  true_path_.push_back({stamp(), world_.T_world_robot()});
  odometry_path_.push_back({stamp(), odometry_.update(travel())});
}

}  // namespace echomap::tests
