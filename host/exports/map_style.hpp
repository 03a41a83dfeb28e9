// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "host/exports/map_view.hpp"
#include "host/geometry/segment.hpp"
#include "host/pipeline/snapshot.hpp"

namespace echomap::exports {

/// The colours of what a map's pictures show beside its cells.
constexpr Colour kEchoColour = kOrange;
constexpr Colour kFittedColour = kPurple;
constexpr Colour kTrailColour = kBlue;
constexpr Colour kRobotColour = kVermilion;
constexpr Colour kOutlineColour = kGreen;
constexpr Colour kStartColour = kSkyBlue;
constexpr Colour kLandmarkColour = kPurple;

/// Landmarks of SLAM, in the map frame.
struct MapLandmarks {
  std::vector<Eigen::Vector2d> points_m{};
  std::vector<geometry::Segment> walls{};

  bool empty() const { return points_m.empty() && walls.empty(); }
};

/// How map.png and map.svg are drawn.
struct MapStyle {
  std::string title{};
  /// How far the picture is turned in the map frame, counter-clockwise.
  double turn_rad = 0.0;
  double robot_radius_m = 0.09;
  /// Whether fitted walls and obstacles are drawn.
  bool shows_features = true;
  MapLandmarks landmarks{};
  /// Whether the picture holds every echo: of a map of points, which has no cells.
  bool holds_echoes = false;
};

/// The legend of a snapshot's pictures: what of all this it has.
std::vector<LegendEntry> legend_of(const pipeline::Snapshot& snapshot,
                                   bool has_outline,
                                   const MapStyle& style);

/// What a picture has to hold beside the cells: the trail and the robot, all around, and the echoes
/// where the style says so.
std::vector<Eigen::Vector2d> held_points_m(const pipeline::Snapshot& snapshot,
                                           const MapStyle& style);

}  // namespace echomap::exports
