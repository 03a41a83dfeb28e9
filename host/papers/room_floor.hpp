// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <Eigen/Core>

#include "hil_mock/world/floor_plan.hpp"
#include "host/mapping/raster_map.hpp"

namespace echomap::papers {

/// A world that comes with echomap. Throws files::ConfigError.
world::FloorPlan bundled_room(const std::string& name);

/// A rectangle along the axes of the world frame, metres.
struct Box {
  Eigen::Vector2d low_m;
  Eigen::Vector2d high_m;

  /// The point at these shares, 0 to 1, of width and height.
  Eigen::Vector2d at(double x_share, double y_share) const {
    return low_m + Eigen::Vector2d(x_share, y_share).cwiseProduct(high_m - low_m);
  }
};

/// The smallest box around a room.
Box box_around(const world::FloorPlan& room);

/// The room's true floor as a map in the world frame, unknown outside, with a margin around its
/// box.
mapping::RasterMap floor_of(const world::FloorPlan& room, double cell_m, double margin_m);

}  // namespace echomap::papers
