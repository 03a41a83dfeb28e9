// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>

#include <nlohmann/json.hpp>

#include "host/evaluation/truth_directory.hpp"
#include "host/geometry/pose2.hpp"
#include "host/mapping/occupancy_grid.hpp"

namespace echomap::apps {

/// Scores the map of a simulated robot as it grows, for the live page alone: nothing that decides
/// sees it.
class LiveScore {
 public:
  /// The truth directory that the simulated robot has begun. Throws files::FileError.
  explicit LiveScore(const std::filesystem::path& truth);

  /// A stop has changed the map, whose frame is the robot's start pose.
  void look_at(const mapping::OccupancyGrid& grid);
  /// As docs/live_protocol.md has it, with the error of a pose whose truth is known.
  nlohmann::ordered_json json(const geometry::Pose2& T_map_robot,
                              const std::optional<geometry::Pose2>& T_map_true_robot) const;

 private:
  evaluation::Truth truth_;
  nlohmann::ordered_json map_;
};

}  // namespace echomap::apps
