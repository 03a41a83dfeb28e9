// SPDX-License-Identifier: MIT
#include "host/papers/bounce_drive.hpp"

#include <cmath>
#include <numbers>

#include "hil_mock/world/contact_physics.hpp"
#include "hil_mock/world/ir_switches.hpp"
#include "hil_mock/world/robot_file.hpp"
#include "host/files/bundled_files.hpp"
#include "host/files/toml_reader.hpp"
#include "host/papers/room_floor.hpp"

namespace echomap::papers {

namespace {

using geometry::Pose2;

/// A drive is looked at for bumps so often.
constexpr double kLookM = 0.005;

}  // namespace

world::RobotParams create_robot() {
  return world::read_robot(
      files::TomlReader::load(files::bundled_file("create", "hil_mock/robots", "body")));
}

WheelErrors::WheelErrors(const world::DriveParams& drive, world::NoiseStream& noise)
    : drive_(drive),
      noise_(noise),
      drive_scale_(1.0 + drive.wheel_diameter_stddev * noise.normal()),
      turn_scale_(drive_scale_ / (1.0 + drive.track_stddev * noise.normal())),
      bend_rad_per_m_(drive.wheel_mismatch_stddev * noise.normal() / drive.track_m) {}

Pose2 WheelErrors::measured(double turn_rad, double drive_m) {
  const auto slip_m = [&](double rolled_m) {
    return drive_.slip_m_per_sqrt_m * std::sqrt(std::abs(rolled_m)) * noise_.normal();
  };
  const double arc_m = 0.5 * drive_.track_m * turn_rad;
  const double turn_slip_rad = (slip_m(arc_m) - slip_m(arc_m)) / drive_.track_m;
  const double left_m = slip_m(drive_m);
  const double right_m = slip_m(drive_m);
  const double bend_rad = (right_m - left_m) / drive_.track_m + bend_rad_per_m_ * drive_m;
  return Pose2(0.0, 0.0, turn_rad * turn_scale_ + turn_slip_rad) *
         Pose2(drive_m * drive_scale_ + 0.5 * (left_m + right_m), 0.0, bend_rad);
}

BounceRobot::BounceRobot(const world::FloorPlan& room, std::uint32_t seed)
    : room_(room), noise_(seed, world::NoisePurpose::kBody), errors_(robot_.drive, noise_) {
  be_carried_off();
}

void BounceRobot::be_carried_off() {
  const Box box = box_around(room_);
  Eigen::Vector2d at_m;
  do {
    const double x_share = noise_.uniform();
    const double y_share = noise_.uniform();
    at_m = box.at(x_share, y_share);
  } while (!room_.is_free(at_m) || room_.clearance_m(at_m) < robot_.body.radius_m + 0.02);
  T_world_robot_ = {at_m.x(), at_m.y(), (2.0 * noise_.uniform() - 1.0) * std::numbers::pi};
}

void BounceRobot::step(double max_m) {
  if (touches()) {
    const double turn_rad = std::numbers::pi * (0.5 + noise_.uniform());
    T_world_robot_ = T_world_robot_ * Pose2(0.0, 0.0, turn_rad);
    T_odom_robot_ = T_odom_robot_ * errors_.measured(turn_rad, 0.0);
    return;
  }
  double driven_m = 0.0;
  while (driven_m < max_m && !touches()) {
    T_world_robot_ =
        world::pushed_out(room_, T_world_robot_ * Pose2(kLookM, 0.0, 0.0), robot_.body.radius_m);
    driven_m += kLookM;
  }
  T_odom_robot_ = T_odom_robot_ * errors_.measured(0.0, driven_m);
  bumps_ += touches() ? 1 : 0;
}

models::ContactReading BounceRobot::contacts() const {
  const world::Contacts bumper = world::contacts_at(room_, T_world_robot_, robot_.body);
  return {bumper.left,
          bumper.right,
          world::beam_detected(room_, T_world_robot_, robot_.parts.beam_detector.value())};
}

bool BounceRobot::touches() const {
  const world::Contacts bumper = world::contacts_at(room_, T_world_robot_, robot_.body);
  return bumper.left || bumper.right;
}

}  // namespace echomap::papers
