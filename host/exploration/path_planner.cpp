// SPDX-License-Identifier: MIT
#include "host/exploration/path_planner.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <numbers>

namespace echomap::exploration {

namespace {

using geometry::CellIndex;

constexpr float kUnreached = std::numeric_limits<float>::infinity();
/// A parent farther off than this many cells is not tried: a line's price takes as many looks.
constexpr std::int32_t kLongestLine = 100;

double distance_m(const CostGrid& grid, CellIndex from, CellIndex to) {
  return grid.resolution_m() * std::hypot(to.x - from.x, to.y - from.y);
}

bool is_far(CellIndex from, CellIndex to) {
  return std::max(std::abs(to.x - from.x), std::abs(to.y - from.y)) > kLongestLine;
}

/// Of a step to a neighbour.
float step_cost_m(const CostGrid& grid, std::uint32_t from, std::uint32_t to) {
  const CellIndex a = grid.cell(from);
  const CellIndex b = grid.cell(to);
  const double length = a.x != b.x && a.y != b.y ? std::numbers::sqrt2 : 1.0;
  const double price = (grid.costs()[from] + grid.costs()[to]) / (2.0 * CostGrid::kPlain);
  return static_cast<float>(grid.resolution_m() * length * price);
}

std::array<std::int32_t, 8> neighbours(const CostGrid& grid) {
  const std::int32_t up = grid.stride();
  return {1, -1, up, -up, up + 1, up - 1, 1 - up, -1 - up};
}

std::uint32_t moved(std::uint32_t at, std::int32_t by) {
  return static_cast<std::uint32_t>(static_cast<std::int32_t>(at) + by);
}

}  // namespace

/// One look for each row or column of the longer side, at both cells beside the line, as the line
/// runs between them; the nearer counts more.
std::optional<double> line_cost_m(const CostGrid& grid, CellIndex from, CellIndex to) {
  const std::int32_t steps = std::max(std::abs(to.x - from.x), std::abs(to.y - from.y));
  if (!grid.is_open(from) || !grid.is_open(to)) {
    return std::nullopt;
  }
  if (steps == 0) {
    return 0.0;
  }
  const bool flat = std::abs(to.x - from.x) == steps;
  const std::int32_t along = (flat ? to.x > from.x : to.y > from.y) ? 1 : -1;
  const std::int32_t ahead = flat ? along : along * grid.stride();
  const std::int32_t aside = flat ? grid.stride() : 1;
  const std::int32_t rise = flat ? to.y - from.y : to.x - from.x;
  const auto start = static_cast<std::int32_t>(grid.index(from));
  const auto& costs = grid.costs();
  double sum = -0.5 * (costs[grid.index(from)] + costs[grid.index(to)]);
  for (std::int32_t i = 0; i <= steps; ++i) {
    const std::int32_t whole = (i * rise + (rise < 0 ? 1 - steps : 0)) / steps;
    const std::int32_t rest = i * rise - whole * steps;
    const std::int32_t at = start + i * ahead + whole * aside;
    const std::int32_t near = costs[static_cast<std::size_t>(at)];
    const std::int32_t beside = at + aside;
    const std::int32_t next = rest > 0 ? costs[static_cast<std::size_t>(beside)] : near;
    if (near == 0 || next == 0) {
      return std::nullopt;
    }
    sum += near + static_cast<double>(rest) * (next - near) / steps;
  }
  return distance_m(grid, from, to) / steps * sum / CostGrid::kPlain;
}

std::optional<PlannedPath> PathPlanner::find(const CostGrid& grid, CellIndex from, CellIndex to) {
  if (!grid.is_open(from) || !grid.is_open(to)) {
    return std::nullopt;
  }
  reset(grid.costs().size());
  const auto start = static_cast<std::uint32_t>(grid.index(from));
  const auto goal = static_cast<std::uint32_t>(grid.index(to));
  nodes_[start] = {0.0F, start, false};
  touched_.push_back(start);
  push(static_cast<float>(distance_m(grid, from, to)), start);
  while (!heap_.empty()) {
    const std::uint32_t at = pop();
    if (nodes_[at].closed) {
      continue;
    }
    nodes_[at].closed = true;
    if (at == goal) {
      return path_to(grid, goal);
    }
    expand(grid, at, to);
  }
  return std::nullopt;
}

/// Only what the last search has touched is made anew.
void PathPlanner::reset(std::size_t cells) {
  constexpr Node kFresh{kUnreached, 0, false};
  if (nodes_.size() != cells) {
    nodes_.assign(cells, kFresh);
  } else {
    for (const std::uint32_t at : touched_) {
      nodes_[at] = kFresh;
    }
  }
  touched_.clear();
  heap_.clear();
}

/// Each neighbour is reached by a straight line from this cell's parent, or by a step from this
/// cell where that is cheaper or the line is closed.
void PathPlanner::expand(const CostGrid& grid, std::uint32_t at, CellIndex goal) {
  const std::uint32_t parent = nodes_[at].parent;
  const CellIndex parent_cell = grid.cell(parent);
  for (const std::int32_t offset : neighbours(grid)) {
    const std::uint32_t next = moved(at, offset);
    if (grid.costs()[next] == 0 || nodes_[next].closed) {
      continue;
    }
    const CellIndex cell = grid.cell(next);
    const auto line_m =
        is_far(parent_cell, cell) ? std::nullopt : line_cost_m(grid, parent_cell, cell);
    const float by_line_m =
        line_m ? nodes_[parent].cost_m + static_cast<float>(*line_m) : kUnreached;
    const float by_step_m = nodes_[at].cost_m + step_cost_m(grid, at, next);
    const float cost_m = std::min(by_line_m, by_step_m);
    Node& node = nodes_[next];
    if (node.cost_m == kUnreached) {
      touched_.push_back(next);
    }
    if (cost_m < node.cost_m) {
      node.cost_m = cost_m;
      node.parent = by_line_m <= by_step_m ? parent : at;
      push(cost_m + static_cast<float>(distance_m(grid, cell, goal)), next);
    }
  }
}

void PathPlanner::push(float estimate_m, std::uint32_t at) {
  heap_.emplace_back(estimate_m, at);
  std::push_heap(heap_.begin(), heap_.end(), std::greater<>());
}

std::uint32_t PathPlanner::pop() {
  std::pop_heap(heap_.begin(), heap_.end(), std::greater<>());
  const std::uint32_t at = heap_.back().second;
  heap_.pop_back();
  return at;
}

PlannedPath PathPlanner::path_to(const CostGrid& grid, std::uint32_t goal) const {
  PlannedPath path;
  path.cost_m = static_cast<double>(nodes_[goal].cost_m);
  for (std::uint32_t at = goal;; at = nodes_[at].parent) {
    path.points_m.push_back(grid.center_m(grid.cell(at)));
    if (nodes_[at].parent == at) {
      break;
    }
  }
  std::reverse(path.points_m.begin(), path.points_m.end());
  return path;
}

}  // namespace echomap::exploration
