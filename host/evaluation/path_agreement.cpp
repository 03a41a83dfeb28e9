// SPDX-License-Identifier: MIT
#include "host/evaluation/path_agreement.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <limits>
#include <optional>
#include <queue>
#include <random>
#include <utility>
#include <vector>

#include "host/evaluation/clear_floor.hpp"
#include "host/geometry/parameter_validator.hpp"

namespace echomap::evaluation {

namespace {

using geometry::CellIndex;
using geometry::Pose2;
using mapping::CellState;
using mapping::RasterMap;

constexpr int kPairs = 200;
constexpr std::uint32_t kSeed = 1;
constexpr double kOccupiedMarginM = 0.05;
constexpr double kUnknownMarginM = 0.10;
constexpr double kEndReachM = 0.10;
constexpr double kTouchStepM = 0.01;
/// Whole lengths of a step, so that paths are the same on every machine.
constexpr std::int32_t kStraightCost = 1000;
constexpr std::int32_t kDiagonalCost = 1414;

constexpr CellIndex kNeighbours[] = {
    {1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {1, -1}, {-1, 1}, {-1, -1}};

/// The map's cells that paths may use, as free ones.
RasterMap open_floor(const RasterMap& map, double robot_radius_m) {
  const RasterMap all = padded(map);
  RasterMap floor = all;
  const auto is_occupied = [](CellState state) { return state == CellState::kOccupied; };
  const auto is_unknown = [](CellState state) { return state == CellState::kUnknown; };
  keep_off(all, is_occupied, robot_radius_m + kOccupiedMarginM, floor);
  keep_off(all, is_unknown, kUnknownMarginM, floor);
  return floor;
}

/// Where pairs are sampled, in the world frame.
std::vector<Eigen::Vector2d> true_floor_m(const RasterMap& truth, double robot_radius_m) {
  const RasterMap all = padded(truth);
  RasterMap floor = all;
  const auto is_no_floor = [](CellState state) { return state != CellState::kFree; };
  keep_off(all, is_no_floor, robot_radius_m + kOccupiedMarginM, floor);
  std::vector<Eigen::Vector2d> largest_m;
  for (int y = 0; y < all.rows(); ++y) {
    for (int x = 0; x < all.columns(); ++x) {
      auto region_m = take_region_m({x, y}, floor);
      if (region_m.size() > largest_m.size()) {
        largest_m = std::move(region_m);
      }
    }
  }
  return largest_m;
}

/// The free cell whose centre is nearest to a point, of those within reach.
std::optional<CellIndex> nearest_free(const RasterMap& floor, const Eigen::Vector2d& point_m) {
  const int reach = static_cast<int>(std::ceil(kEndReachM / floor.resolution_m()));
  const CellIndex middle = floor.cell_at(point_m);
  std::optional<CellIndex> nearest;
  double min_m = kEndReachM;
  for (int y = middle.y - reach; y <= middle.y + reach; ++y) {
    for (int x = middle.x - reach; x <= middle.x + reach; ++x) {
      const double distance_m = (floor.center_m({x, y}) - point_m).norm();
      if (floor.state({x, y}) == CellState::kFree && distance_m <= min_m) {
        nearest = {x, y};
        min_m = distance_m;
      }
    }
  }
  return nearest;
}

/// Shortest paths over the free cells of a raster: A*.
class CellSearch {
 public:
  explicit CellSearch(const RasterMap& floor) : floor_(floor) {}

  /// From the goal back to the start; empty where no path leads there.
  std::vector<CellIndex> find(CellIndex start, CellIndex goal) {
    nodes_.assign(index_of({0, floor_.rows()}), Node{});
    queue_ = {};
    reach(start, start, 0, goal);
    while (!queue_.empty()) {
      const CellIndex cell = queue_.top().second;
      queue_.pop();
      if (cell == goal) {
        return path_to(goal);
      }
      expand(cell, goal);
    }
    return {};
  }

 private:
  struct Node {
    std::int32_t cost = std::numeric_limits<std::int32_t>::max();
    CellIndex parent;
    bool closed = false;
  };

  std::size_t index_of(CellIndex cell) const {
    return static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(floor_.columns()) +
           static_cast<std::size_t>(cell.x);
  }

  void expand(CellIndex cell, CellIndex goal) {
    Node& node = nodes_[index_of(cell)];
    if (std::exchange(node.closed, true)) {
      return;
    }
    for (const CellIndex step : kNeighbours) {
      const CellIndex next{cell.x + step.x, cell.y + step.y};
      if (floor_.state(next) == CellState::kFree) {
        reach(next,
              cell,
              node.cost + (step.x != 0 && step.y != 0 ? kDiagonalCost : kStraightCost),
              goal);
      }
    }
  }

  void reach(CellIndex cell, CellIndex parent, std::int32_t cost, CellIndex goal) {
    Node& node = nodes_[index_of(cell)];
    if (cost < node.cost) {
      node.cost = cost;
      node.parent = parent;
      const std::int32_t dx = std::abs(goal.x - cell.x);
      const std::int32_t dy = std::abs(goal.y - cell.y);
      const std::int32_t diagonal = std::min(dx, dy);
      queue_.emplace(
          cost + diagonal * kDiagonalCost + (std::max(dx, dy) - diagonal) * kStraightCost, cell);
    }
  }

  std::vector<CellIndex> path_to(CellIndex goal) const {
    std::vector<CellIndex> path{goal};
    while (nodes_[index_of(path.back())].parent != path.back()) {
      path.push_back(nodes_[index_of(path.back())].parent);
    }
    return path;
  }

  using Entry = std::pair<std::int32_t, CellIndex>;
  const RasterMap& floor_;
  std::vector<Node> nodes_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
};

/// Whether a robot at a point would touch something.
bool touches(const Eigen::Vector2d& point_m, const MapTruth& truth, double robot_radius_m) {
  return truth.cells.state(truth.cells.cell_at(point_m)) != CellState::kFree ||
         std::any_of(truth.walls.begin(), truth.walls.end(), [&](const geometry::Segment& wall) {
           return geometry::distance_m(wall, point_m) < robot_radius_m;
         });
}

bool path_touches(const std::vector<Eigen::Vector2d>& path_m,
                  const MapTruth& truth,
                  double robot_radius_m) {
  for (std::size_t i = 0; i < path_m.size(); ++i) {
    const Eigen::Vector2d step_m = path_m[std::min(i + 1, path_m.size() - 1)] - path_m[i];
    const int parts = std::max(1, static_cast<int>(std::ceil(step_m.norm() / kTouchStepM)));
    for (int k = 0; k < parts; ++k) {
      const Eigen::Vector2d point_m = path_m[i] + static_cast<double>(k) / parts * step_m;
      if (touches(point_m, truth, robot_radius_m)) {
        return true;
      }
    }
  }
  return false;
}

const Eigen::Vector2d& sample(const std::vector<Eigen::Vector2d>& points_m, std::mt19937& random) {
  return points_m[static_cast<std::size_t>((std::uint64_t{random()} * points_m.size()) >> 32U)];
}

}  // namespace

PathAgreement score_paths(const RasterMap& map,
                          const Pose2& T_world_map,
                          const MapTruth& truth,
                          double robot_radius_m) {
  geometry::ParameterValidator("path score").positive("robot_radius_m", robot_radius_m);
  const auto places_m = true_floor_m(truth.cells, robot_radius_m);
  PathAgreement agreement;
  if (places_m.empty()) {
    return agreement;
  }
  const RasterMap floor = open_floor(map, robot_radius_m);
  const Pose2 T_map_world = T_world_map.inverse();
  CellSearch search(floor);
  std::mt19937 random(kSeed);
  for (int i = 0; i < kPairs; ++i) {
    const auto start = nearest_free(floor, T_map_world * sample(places_m, random));
    const auto goal = nearest_free(floor, T_map_world * sample(places_m, random));
    ++agreement.pairs;
    std::vector<Eigen::Vector2d> path_m;
    if (start && goal) {
      for (const CellIndex cell : search.find(*start, *goal)) {
        path_m.emplace_back(T_world_map * floor.center_m(cell));
      }
    }
    agreement.paths += path_m.empty() ? 0U : 1U;
    agreement.collisions += path_touches(path_m, truth, robot_radius_m) ? 1U : 0U;
  }
  return agreement;
}

}  // namespace echomap::evaluation
