// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>
#include <nlohmann/json_fwd.hpp>

#include "host/geometry/cell_index.hpp"
#include "host/geometry/pose2.hpp"
#include "host/live_page/message.hpp"
#include "host/mapping/grid_tile.hpp"

namespace echomap::live_page {

/// What the last ping heard, as a motion says it.
enum class PingResult : std::uint32_t { kNone = 0, kEcho = 1, kSilence = 2, kNoAnswer = 3 };

/// The last ping of the robot's sonar.
struct LastPing {
  double bearing_rad = 0.0;  ///< Of its beam in the robot's frame.
  std::optional<double> range_m;
  std::uint32_t number = 0;  ///< Changes with every ping; 0 before the first.
  PingResult result = PingResult::kNone;
};

/// Where the robot is at one instant.
struct MotionView {
  double clock_ms = 0.0;  ///< The server's.
  geometry::Pose2 T_map_robot;
  /// Of x, y (m) and heading (rad); empty where nothing says it.
  std::optional<Eigen::Matrix3d> covariance;
  geometry::Pose2 T_odom_robot;
  std::optional<geometry::Pose2> T_map_true_robot;
  LastPing ping;
};

/// A particle's pose and its weight.
struct WeightedPose {
  geometry::Pose2 T_map_robot;
  double weight = 0.0;
};

// Messages of docs/live_protocol.md at a time of the run.
SharedMessage tile_message(double time_s, geometry::CellIndex tile, const mapping::GridTile& cells);
SharedMessage motion_message(double time_s, const MotionView& motion);
SharedMessage particles_message(double time_s, const std::vector<WeightedPose>& particles);
SharedMessage trail_message(double time_s, const std::vector<Eigen::Vector2d>& positions_m);
SharedMessage json_message(MessageKind kind, double time_s, const nlohmann::ordered_json& json);
SharedMessage new_map_message(double time_s);

}  // namespace echomap::live_page
