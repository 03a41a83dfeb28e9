// SPDX-License-Identifier: MIT
#include "hil_mock/world/robot_world.hpp"

#include <utility>

namespace echomap::world {

RobotWorld::RobotWorld(FloorPlan plan, const RobotParams& robot, std::uint32_t seed)
    : plan_(std::move(plan)),
      robot_(robot),
      body_(plan_, robot.drive, robot.body, NoiseStream(seed, NoisePurpose::kBody)),
      sonar_(plan_, robot.sonar),
      sonar_noise_(seed, NoisePurpose::kSonar),
      parts_(plan_, body_, robot.parts, seed) {}

void RobotWorld::step(double dt_s, const WheelDuty& duty, EncoderChanges& changes) {
  body_.step(dt_s, duty, changes);
  parts_.step(dt_s, duty);
}

void RobotWorld::place(const geometry::Pose2& T_world_robot) {
  body_.place(T_world_robot);
  parts_.forget_heading();
}

std::optional<double> RobotWorld::ping(double pan_rad) {
  const auto range_m = sonar_.ping_m(T_world_sonar(pan_rad), sonar_noise_);
  if (!range_m) {
    return std::nullopt;
  }
  return 2.0 * *range_m / robot_.sonar.speed_of_sound_m_per_s;
}

geometry::Pose2 RobotWorld::T_world_sonar(double pan_rad) const {
  return T_world_robot() * geometry::Pose2(robot_.sonar.mount_x_m, robot_.sonar.mount_y_m, pan_rad);
}

}  // namespace echomap::world
