// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "hil_mock/world/floor_plan.hpp"
#include "host/mapping/raster_map.hpp"

namespace echomap::bench {

/// The edge of the box.
constexpr double kBoxM = 0.35;

/// A room, its robot's two starts and two places for the box, drawn from a seed.
class BoxScene {
 public:
  /// Throws std::runtime_error, with the room's name, where it has no place for the box.
  BoxScene(const std::string& room, std::uint32_t seed);

  const geometry::Pose2& before_start() const { return before_start_; }
  const Eigen::Vector2d& place_m(std::size_t box) const { return place_m_[box]; }

  /// A map of the room with these of the boxes, from the first start or the second.
  mapping::RasterMap mapped(const std::vector<std::size_t>& boxes, bool after);

 private:
  double signed_share();
  geometry::Pose2 near_start();
  Eigen::Vector2d somewhere_m();
  bool has_room_for_box(const Eigen::Vector2d& place_m) const;

  world::FloorPlan plan_;
  std::mt19937 random_;
  std::uint32_t seed_;
  std::uint32_t runs_ = 0;
  geometry::Pose2 before_start_;
  geometry::Pose2 after_start_;
  std::vector<Eigen::Vector2d> place_m_;
};

}  // namespace echomap::bench
