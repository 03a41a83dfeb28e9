// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <Eigen/Core>

#include "host/mapping/raster_map.hpp"

namespace echomap::exports {

/// The rectangle of the map frame that a picture shows, and how the picture is turned in it. Only
/// pictures are turned, never data.
struct PictureFrame {
  /// From the map's x axis to the picture's, counter-clockwise.
  double turn_rad = 0.0;
  /// Lower left corner, in the picture's axes.
  Eigen::Vector2d low_m = Eigen::Vector2d::Zero();
  Eigen::Vector2d size_m = Eigen::Vector2d::Zero();

  /// A point of the map frame in the picture's axes, from the map's origin.
  Eigen::Vector2d in_picture_m(const Eigen::Vector2d& point_m) const;
  /// The other way.
  Eigen::Vector2d in_map_m(const Eigen::Vector2d& picture_m) const;
};

/// The frame that holds a map and these points. Not turned, it holds the whole map, else the cells
/// that are known and a margin of one cell. Its sides are whole cells long.
PictureFrame frame_of(const mapping::RasterMap& map,
                      double turn_rad,
                      const std::vector<Eigen::Vector2d>& points_m);

}  // namespace echomap::exports
