// SPDX-License-Identifier: MIT
#include "host/exploration/viewpoint_choice.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "host/geometry/angle.hpp"

namespace echomap::exploration {

namespace {

using geometry::CellIndex;

struct Place {
  CellIndex cell;
  double cost_m = 0.0;
};

/// Cells of a lattice that are near a frontier and within the robot's reach, the nearest first.
std::vector<Place> places_to_try(const CostGrid& grid,
                                 const TravelField& travel,
                                 const std::vector<FrontierCells>& frontiers,
                                 const ViewpointParams& params) {
  const auto spacing =
      std::max(1, static_cast<std::int32_t>(std::lround(params.spacing_m / grid.resolution_m())));
  const auto far = static_cast<std::int32_t>(std::ceil(params.far_m / params.spacing_m));
  const std::int32_t columns = grid.columns() / spacing + 1;
  const std::int32_t rows = grid.rows() / spacing + 1;
  std::vector<char> is_near(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
  std::vector<Place> places;
  const auto try_node = [&](std::int32_t x, std::int32_t y) {
    char& near = is_near[static_cast<std::size_t>(y) * static_cast<std::size_t>(columns) +
                         static_cast<std::size_t>(x)];
    const CellIndex cell{x * spacing, y * spacing};
    const auto cost_m = near == 0 ? travel.cost_m(cell) : std::nullopt;
    near = 1;
    if (cost_m) {
      places.push_back({cell, *cost_m});
    }
  };
  const auto try_around = [&](const CellIndex& node) {
    const std::int32_t max_x = std::min(columns - 1, node.x + far);
    const std::int32_t max_y = std::min(rows - 1, node.y + far);
    for (std::int32_t y = std::max(0, node.y - far); y <= max_y; ++y) {
      for (std::int32_t x = std::max(0, node.x - far); x <= max_x; ++x) {
        try_node(x, y);
      }
    }
  };
  std::vector<char> is_done(is_near.size());
  for (const FrontierCells& frontier : frontiers) {
    for (const CellIndex cell : frontier) {
      const CellIndex node{cell.x / spacing, cell.y / spacing};
      char& done = is_done[static_cast<std::size_t>(node.y) * static_cast<std::size_t>(columns) +
                           static_cast<std::size_t>(node.x)];
      if (done != 0) {
        continue;
      }
      done = 1;
      try_around(node);
    }
  }
  std::stable_sort(places.begin(), places.end(), [](const Place& a, const Place& b) {
    return a.cost_m < b.cost_m;
  });
  places.resize(std::min(places.size(), params.max_places));
  return places;
}

double time_s(const Place& place,
              const Eigen::Vector2d& at_m,
              const BestView& view,
              const geometry::Pose2& T_map_robot,
              const ViewpointParams& params) {
  const Eigen::Vector2d offset_m = at_m - T_map_robot.position_m();
  double heading_rad = T_map_robot.heading_rad();
  double turned_rad = 0.0;
  if (place.cost_m > 0.0) {
    const double bearing_rad = std::atan2(offset_m.y(), offset_m.x());
    turned_rad += std::abs(geometry::angle_between(heading_rad, bearing_rad));
    heading_rad = bearing_rad;
  }
  turned_rad += std::abs(geometry::angle_between(heading_rad, view.middle_rad));
  return params.stop_s + place.cost_m / params.speed_m_per_s + turned_rad / params.turn_rad_per_s +
         view.width_rad * params.sweep_s_per_rad;
}

}  // namespace

std::vector<Viewpoint> weigh_viewpoints(const CostGrid& grid,
                                        const TravelField& travel,
                                        const std::vector<FrontierCells>& frontiers,
                                        const ViewGain& gain,
                                        const geometry::Pose2& T_map_robot,
                                        const ViewpointParams& params) {
  std::vector<Place> places = places_to_try(grid, travel, frontiers, params);
  places.push_back({grid.cell_at(T_map_robot.position_m()), 0.0});
  std::vector<Viewpoint> viewpoints;
  for (const Place& place : places) {
    const Eigen::Vector2d at_m =
        place.cost_m > 0.0 ? grid.center_m(place.cell) : T_map_robot.position_m();
    const auto by_sector_m2 = gain.by_sector_m2(at_m);
    for (const double width_rad : params.widths_rad) {
      const BestView view = best_view(by_sector_m2, width_rad);
      const double gain_per_s = view.gain_m2 / time_s(place, at_m, view, T_map_robot, params);
      if (view.gain_m2 >= params.min_gain_m2) {
        viewpoints.push_back({at_m, view, place.cost_m, gain_per_s});
      }
    }
  }
  std::stable_sort(viewpoints.begin(), viewpoints.end(), [](const auto& a, const auto& b) {
    return a.gain_per_s > b.gain_per_s;
  });
  return viewpoints;
}

}  // namespace echomap::exploration
