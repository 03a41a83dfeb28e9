// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include <Eigen/Core>

#include "hil_mock/world/floor_plan.hpp"
#include "host/exports/map_view.hpp"
#include "host/geometry/pose2.hpp"
#include "host/localization/particles.hpp"

namespace echomap::papers {

/// Positions of all particles, in the map frame.
std::vector<Eigen::Vector2d> positions_of(const localization::Particles& particles);

/// A picture of a simulated room: its true walls, and points and robots drawn onto it. All places
/// are in the world frame.
class RoomPicture {
 public:
  /// The legend explains the colours that are drawn later; around the room is a margin.
  RoomPicture(const world::FloorPlan& room,
              std::vector<exports::LegendEntry> legend,
              double margin_m = 0.2);

  void add_points(const std::vector<Eigen::Vector2d>& points_m,
                  double radius_px,
                  exports::Colour colour);
  /// Draws lines from point to point.
  void add_path(const std::vector<Eigen::Vector2d>& points_m,
                double width_px,
                exports::Colour colour);
  /// Draws the ellipse of `sigmas` standard deviations of a position, and a cross at its mean.
  void add_ellipse(const Eigen::Vector2d& mean_m,
                   const Eigen::Matrix2d& covariance_m2,
                   double sigmas,
                   exports::Colour colour);
  /// Draws a circle with a line to where the robot faces.
  void add_robot(const geometry::Pose2& T_world_robot, double radius_m, exports::Colour colour);
  /// Writes the picture below `file` and returns its bytes. Throws files::FileError.
  std::vector<std::uint8_t> write_png(const std::filesystem::path& file) const;

 private:
  exports::MapView view_;
  exports::Picture picture_;
};

}  // namespace echomap::papers
