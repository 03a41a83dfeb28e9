// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include <Eigen/Core>

#include "host/geometry/pose2.hpp"
#include "host/geometry/segment.hpp"

namespace echomap::papers {

/// One of several maps of the same place, all in its own map frame.
struct MapPanel {
  std::vector<Eigen::Vector2d> ends_m{};    ///< Where beams ended.
  std::vector<geometry::Pose2> path{};      ///< Of the robot.
  std::vector<geometry::Segment> walls{};   ///< Landmarks that are walls.
  std::vector<Eigen::Vector2d> points_m{};  ///< Landmarks that are points.
  std::vector<geometry::Segment> true_walls{};
};

/// Draws maps beside each other, with the same scale, below `file`, and returns the bytes of the
/// picture. Cells of `cell_m` in which at least three beams ended are dark. Throws
/// std::invalid_argument for a panel of nothing, and files::FileError.
std::vector<std::uint8_t> draw_panels(const std::filesystem::path& file,
                                      const std::vector<MapPanel>& panels,
                                      double cell_m);

}  // namespace echomap::papers
