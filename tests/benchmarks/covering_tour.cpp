// SPDX-License-Identifier: MIT
#include "tests/benchmarks/covering_tour.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

#include "hil_mock/runner/truth_map.hpp"
#include "host/exploration/path_planner.hpp"
#include "host/exploration/travel_field.hpp"
#include "host/files/atomic_file.hpp"

namespace echomap::bench {
namespace {

using exploration::CostGrid;
using mapping::CellState;
using mapping::RasterMap;

/// The room as a map without an error, in the world frame; a hole is as bad as a wall.
RasterMap drawn(const world::FloorPlan& plan, double cell_m) {
  const runner::TruthMap truth = runner::draw_truth_map(plan, cell_m);
  RasterMap map(truth.width, truth.height, cell_m, {truth.origin_x_m, truth.origin_y_m});
  for (int y = 0; y < truth.height; ++y) {
    for (int x = 0; x < truth.width; ++x) {
      const bool is_free = truth.at(x, y) == runner::TruthCell::kFree;
      const bool is_closed =
          truth.at(x, y) == runner::TruthCell::kOccupied || plan.is_hole(map.center_m({x, y}));
      map.set(
          {x, y},
          is_free ? CellState::kFree : (is_closed ? CellState::kOccupied : CellState::kUnknown));
    }
  }
  return map;
}

CostGrid costs_of(const world::FloorPlan& plan, const CoveringTourParams& params) {
  exploration::CostGridParams costs;
  costs.robot_radius_m = params.robot_radius_m;
  costs.clearance_m = params.clearance_m;
  costs.standing_m = 0.0;
  return {drawn(plan, params.cell_m), plan.T_world_start().position_m(), costs};
}

std::vector<Eigen::Vector2d> candidates_m(const CostGrid& grid,
                                          const exploration::TravelField& from_start,
                                          int stride) {
  std::vector<Eigen::Vector2d> candidates_m;
  for (int y = stride / 2; y < grid.rows(); y += stride) {
    for (int x = stride / 2; x < grid.columns(); x += stride) {
      if (from_start.reaches({x, y})) {
        candidates_m.push_back(grid.center_m({x, y}));
      }
    }
  }
  return candidates_m;
}

/// Costs of the ways between all stops.
std::vector<std::vector<double>> ways_between(const CostGrid& grid,
                                              const std::vector<Eigen::Vector2d>& stops_m) {
  std::vector<std::vector<double>> costs_m;
  exploration::TravelField field;
  for (const Eigen::Vector2d& from_m : stops_m) {
    field.search(grid, grid.cell_at(from_m));
    std::vector<double>& row_m = costs_m.emplace_back();
    for (const Eigen::Vector2d& to_m : stops_m) {
      row_m.push_back(
          field.cost_m(grid.cell_at(to_m)).value_or(std::numeric_limits<double>::infinity()));
    }
  }
  return costs_m;
}

std::vector<std::size_t> nearest_first(const std::vector<std::vector<double>>& costs_m) {
  std::vector<std::size_t> order(costs_m.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    order[i] = i;
  }
  for (std::size_t i = 1; i < order.size(); ++i) {
    const auto& from_m = costs_m[order[i - 1]];
    const auto nearest =
        std::min_element(order.begin() + static_cast<std::ptrdiff_t>(i),
                         order.end(),
                         [&](std::size_t a, std::size_t b) { return from_m[a] < from_m[b]; });
    std::iter_swap(order.begin() + static_cast<std::ptrdiff_t>(i), nearest);
  }
  return order;
}

/// Turns a piece of the order round where that makes it shorter, until none does.
void exchange(const std::vector<std::vector<double>>& costs_m, std::vector<std::size_t>& order) {
  constexpr double kRoundingM = 1e-6;
  for (bool is_shorter = true; is_shorter;) {
    is_shorter = false;
    for (std::size_t i = 1; i + 1 < order.size(); ++i) {
      for (std::size_t j = i + 1; j < order.size(); ++j) {
        const double before_m = costs_m[order[i - 1]][order[i]] +
                                (j + 1 < order.size() ? costs_m[order[j]][order[j + 1]] : 0.0);
        const double after_m = costs_m[order[i - 1]][order[j]] +
                               (j + 1 < order.size() ? costs_m[order[i]][order[j + 1]] : 0.0);
        if (after_m < before_m - kRoundingM) {
          std::reverse(order.begin() + static_cast<std::ptrdiff_t>(i),
                       order.begin() + static_cast<std::ptrdiff_t>(j) + 1);
          is_shorter = true;
        }
      }
    }
  }
}

std::vector<exploration::TourPlace> places_of(const CostGrid& grid,
                                              const std::vector<Eigen::Vector2d>& stops_m,
                                              const geometry::Pose2& T_world_map) {
  const geometry::Pose2 T_map_world = T_world_map.inverse();
  exploration::PathPlanner planner;
  std::vector<exploration::TourPlace> places;
  for (std::size_t i = 0; i < stops_m.size(); ++i) {
    if (i > 0) {
      const auto path = planner.find(grid, grid.cell_at(stops_m[i - 1]), grid.cell_at(stops_m[i]));
      for (std::size_t k = 1; path && k + 1 < path->points_m.size(); ++k) {
        places.push_back(
            {fmt::format("on the way to {}", i), T_map_world * path->points_m[k], false});
      }
    }
    places.push_back({fmt::format("stop {}", i), T_map_world * stops_m[i]});
  }
  return places;
}

}  // namespace

CoveringTour covering_tour(const world::FloorPlan& plan, const CoveringTourParams& params) {
  const CostGrid grid = costs_of(plan, params);
  const Eigen::Vector2d start_m = plan.T_world_start().position_m();
  exploration::TravelField from_start;
  from_start.search(grid, grid.cell_at(start_m));
  const auto places_m = candidates_m(grid, from_start, params.candidate_cells);
  if (places_m.empty()) {
    throw std::invalid_argument("room '" + plan.name() + "' has no floor for the robot to move on");
  }
  const auto chosen_m = choose_stops(plan, places_m, start_m, params.stops);
  const auto costs_m = ways_between(grid, chosen_m);
  auto order = nearest_first(costs_m);
  exchange(costs_m, order);
  CoveringTour tour;
  for (const std::size_t i : order) {
    tour.stops_m.push_back(chosen_m[i]);
  }
  tour.places = places_of(grid, tour.stops_m, plan.T_world_start());
  return tour;
}

void write_stop_list(const std::filesystem::path& path,
                     const std::vector<exploration::TourPlace>& places) {
  std::string text;
  for (const exploration::TourPlace& place : places) {
    text += fmt::format("[[place]]\nname = \"{}\"\nx_m = {:.4f}\ny_m = {:.4f}\nsweep = {}\n\n",
                        place.name,
                        place.position_m.x(),
                        place.position_m.y(),
                        place.sweeps);
  }
  files::write_text_file(path, text);
}

}  // namespace echomap::bench
