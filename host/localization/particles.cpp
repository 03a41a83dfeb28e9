// SPDX-License-Identifier: MIT
#include "host/localization/particles.hpp"

namespace echomap::localization {

void Particles::resize(std::size_t count) {
  x_m.resize(count);
  y_m.resize(count);
  heading_rad.resize(count);
  log_weight.resize(count);
}

void Particles::set_pose(std::size_t i, const geometry::Pose2& T_map_robot) {
  x_m[i] = static_cast<float>(T_map_robot.x_m());
  y_m[i] = static_cast<float>(T_map_robot.y_m());
  heading_rad[i] = static_cast<float>(T_map_robot.heading_rad());
}

geometry::Pose2 Particles::pose(std::size_t i) const { return {x_m[i], y_m[i], heading_rad[i]}; }

}  // namespace echomap::localization
