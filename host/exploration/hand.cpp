// SPDX-License-Identifier: MIT
#include "host/exploration/hand.hpp"

namespace echomap::exploration {

geometry::Pose2 mirrored(const geometry::Pose2& T_map_robot) {
  return {T_map_robot.x_m(), -T_map_robot.y_m(), -T_map_robot.heading_rad()};
}

Roll mirrored(const Roll& roll) { return {roll.forward_m_per_s, -roll.turn_rad_per_s, roll.for_s}; }

}  // namespace echomap::exploration
