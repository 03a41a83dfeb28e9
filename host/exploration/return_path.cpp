// SPDX-License-Identifier: MIT
#include "host/exploration/return_path.hpp"

#include "host/mapping/raster_map.hpp"

namespace echomap::exploration {

std::optional<Motion> ReturnPath::next(const pipeline::Snapshot& snapshot) {
  const geometry::Pose2& here = snapshot.latest.T_map_robot;
  if (!grid_) {
    grid_.emplace(mapping::rasterize(*snapshot.grid), here.position_m(), costs_);
    const auto path = planner_.find(
        *grid_, grid_->cell_at(here.position_m()), grid_->cell_at(Eigen::Vector2d::Zero()));
    follower_.follow(path ? path->points_m : std::vector<Eigen::Vector2d>{});
  }
  return follower_.next(here, *grid_);
}

}  // namespace echomap::exploration
