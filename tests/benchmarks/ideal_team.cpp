// SPDX-License-Identifier: MIT
#include "tests/benchmarks/ideal_team.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <stdexcept>
#include <utility>

#include "host/evaluation/clear_floor.hpp"
#include "host/evaluation/floor_seen.hpp"
#include "host/geometry/parameter_validator.hpp"

namespace echomap::bench {
namespace {

using mapping::CellState;
using mapping::RasterMap;

constexpr double kNever = std::numeric_limits<double>::infinity();

/// The floor on a lattice: where a robot's centre may be, what can be seen, and from where what.
class IdealRoom {
 public:
  IdealRoom(const RasterMap& floor, const Eigen::Vector2d& start_m, const IdealTeamParams& params)
      : params_(params), floor_(floor), clear_(floor) {
    evaluation::keep_off(
        floor,
        [](CellState state) { return state != CellState::kFree; },
        params.robot_radius_m,
        clear_);
    columns_ = count_of(floor.columns());
    rows_ = count_of(floor.rows());
    cells_.resize(static_cast<std::size_t>(columns_ * rows_), -1);
    for (const Eigen::Vector2d& at_m :
         evaluation::floor_in_reach_m(floor, start_m, params.robot_radius_m)) {
      int& cell = cells_[node_at(at_m)];
      cell = cell < 0 ? cell_count_++ : cell;
    }
    views_.resize(cells_.size());
  }

  std::size_t cell_count() const { return static_cast<std::size_t>(cell_count_); }
  std::size_t node_at(const Eigen::Vector2d& at_m) const {
    const Eigen::Vector2d from_m = (at_m - floor_.origin_m()) / params_.cell_m;
    const int x = std::clamp(static_cast<int>(std::floor(from_m.x())), 0, columns_ - 1);
    const int y = std::clamp(static_cast<int>(std::floor(from_m.y())), 0, rows_ - 1);
    return static_cast<std::size_t>(y * columns_ + x);
  }
  /// The cell of the floor in reach at that node; below 0 where there is none.
  int cell(std::size_t node) const { return cells_[node]; }
  bool is_clear(std::size_t node) const {
    return clear_.state(clear_.cell_at(middle_m(node))) == CellState::kFree;
  }
  /// Whether that is one of the places to look from.
  bool is_place(std::size_t node) const {
    const auto step = std::max<std::size_t>(
        1, static_cast<std::size_t>(std::lround(params_.place_m / params_.cell_m)));
    const auto columns = static_cast<std::size_t>(columns_);
    return (node % columns) % step == 0 && (node / columns) % step == 0 && is_clear(node);
  }
  Eigen::Vector2d middle_m(std::size_t node) const {
    const auto columns = static_cast<std::size_t>(columns_);
    const Eigen::Vector2d cells(static_cast<double>(node % columns),
                                static_cast<double>(node / columns));
    return floor_.origin_m() + params_.cell_m * (cells + Eigen::Vector2d(0.5, 0.5));
  }
  std::size_t node_count() const { return cells_.size(); }

  /// The cells that are seen from there.
  const std::vector<int>& view(std::size_t node) {
    if (views_[node].empty()) {
      views_[node] = seen_from(node);
    }
    return views_[node];
  }

  /// Metres of way from there to each node over clear ones that `may_pass`.
  template <class MayPass>
  std::vector<double> paths_m(std::size_t from, const MayPass& may_pass) const {
    using Entry = std::pair<double, std::size_t>;
    std::vector<double> paths_m(cells_.size(), kNever);
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    paths_m[from] = 0.0;
    open.emplace(0.0, from);
    while (!open.empty()) {
      const auto [path_m, node] = open.top();
      open.pop();
      if (path_m > paths_m[node]) {
        continue;
      }
      for (const std::size_t next : neighbours(node)) {
        const double next_m = path_m + (middle_m(next) - middle_m(node)).norm();
        if (next_m < paths_m[next] && is_clear(next) && may_pass(next)) {
          paths_m[next] = next_m;
          open.emplace(next_m, next);
        }
      }
    }
    return paths_m;
  }

 private:
  int count_of(int raster_cells) const {
    return static_cast<int>(std::ceil(raster_cells * floor_.resolution_m() / params_.cell_m)) + 1;
  }

  std::vector<std::size_t> neighbours(std::size_t node) const {
    std::vector<std::size_t> near;
    const int column = static_cast<int>(node) % columns_;
    const int row = static_cast<int>(node) / columns_;
    for (int y = std::max(0, row - 1); y <= std::min(rows_ - 1, row + 1); ++y) {
      for (int x = std::max(0, column - 1); x <= std::min(columns_ - 1, column + 1); ++x) {
        near.push_back(static_cast<std::size_t>(y * columns_ + x));
      }
    }
    return near;
  }

  std::vector<int> seen_from(std::size_t node) const {
    std::vector<int> seen;
    const Eigen::Vector2d eye_m = middle_m(node);
    for (std::size_t other = 0; other < cells_.size(); ++other) {
      if (cells_[other] >= 0 && (middle_m(other) - eye_m).norm() <= params_.view_m &&
          is_in_sight(eye_m, middle_m(other))) {
        seen.push_back(cells_[other]);
      }
    }
    return seen;
  }

  /// Up to the last cell, whose middle may lie beside the floor.
  bool is_in_sight(const Eigen::Vector2d& eye_m, const Eigen::Vector2d& at_m) const {
    const double distance_m = std::max(0.0, (at_m - eye_m).norm() - params_.cell_m);
    const double step_m = 0.5 * floor_.resolution_m();
    for (double offset_m = 0.0; offset_m < distance_m; offset_m += step_m) {
      const Eigen::Vector2d point_m = eye_m + (at_m - eye_m).normalized() * offset_m;
      if (floor_.state(floor_.cell_at(point_m)) != CellState::kFree) {
        return false;
      }
    }
    return true;
  }

  IdealTeamParams params_;
  const RasterMap& floor_;
  RasterMap clear_;
  int columns_ = 0;
  int rows_ = 0;
  std::vector<int> cells_;  ///< By node.
  int cell_count_ = 0;
  std::vector<std::vector<int>> views_;
};

struct IdealRobot {
  std::size_t node = 0;
  std::size_t group = 0;     ///< Of those who share.
  double next_s = 0.0;       ///< When it has looked from its node.
  bool is_idle = false;      ///< It knows of nothing to look at.
  std::vector<char> seen{};  ///< By itself.
};

class IdealTeam {
 public:
  IdealTeam(const RasterMap& floor,
            const std::vector<Eigen::Vector2d>& starts_m,
            const IdealTeamParams& params)
      : params_(params), room_(floor, starts_m.front(), params) {
    for (std::size_t i = 0; i < starts_m.size(); ++i) {
      robots_.push_back({room_.node_at(starts_m[i]),
                         params.shared_m2 > 0.0 ? i : 0,
                         params.stop_s,
                         false,
                         std::vector<char>(room_.cell_count(), 0)});
      known_.emplace_back(room_.cell_count(), 0);
    }
  }

  std::optional<double> run() {
    while (IdealRobot* robot = next()) {
      const double now_s = robot->next_s;
      look(*robot);
      share();
      if (share_known(robot->group) >= params_.enough_share) {
        return now_s;
      }
      robot->is_idle = true;
      for (IdealRobot& other : robots_) {
        if (other.is_idle) {
          decide(other, now_s);
        }
      }
    }
    return std::nullopt;
  }

 private:
  IdealRobot* next() {
    IdealRobot* first = nullptr;
    for (IdealRobot& robot : robots_) {
      if (!robot.is_idle && (first == nullptr || robot.next_s < first->next_s)) {
        first = &robot;
      }
    }
    return first;
  }

  void look(IdealRobot& robot) {
    for (const int cell : room_.view(robot.node)) {
      robot.seen[static_cast<std::size_t>(cell)] = 1;
      known_[robot.group][static_cast<std::size_t>(cell)] = 1;
    }
  }

  double share_known(std::size_t group) const {
    return static_cast<double>(std::ranges::count(known_[group], 1)) /
           static_cast<double>(room_.cell_count());
  }

  /// Those of two groups who have seen enough of the same floor make them one.
  void share() {
    for (const IdealRobot& one : robots_) {
      for (const IdealRobot& other : robots_) {
        if (one.group < other.group && common_m2(one.seen, other.seen) >= params_.shared_m2) {
          unite(one.group, other.group);
        }
      }
    }
  }

  double common_m2(const std::vector<char>& some, const std::vector<char>& others) const {
    std::size_t common = 0;
    for (std::size_t i = 0; i < some.size(); ++i) {
      common += some[i] != 0 && others[i] != 0 ? 1U : 0U;
    }
    return static_cast<double>(common) * params_.cell_m * params_.cell_m;
  }

  void unite(std::size_t group, std::size_t into_it) {
    for (IdealRobot& robot : robots_) {
      robot.group = robot.group == into_it ? group : robot.group;
    }
    for (std::size_t i = 0; i < known_[group].size(); ++i) {
      known_[group][i] = static_cast<char>(known_[group][i] | known_[into_it][i]);
    }
  }

  /// To the place that shows most for its time, over floor that it knows; floor that is in sight
  /// from where others of its group go counts as seen.
  void decide(IdealRobot& robot, double now_s) {
    std::vector<char> taken = known_[robot.group];
    for (const IdealRobot& other : robots_) {
      if (&other != &robot && other.group == robot.group && !other.is_idle) {
        for (const int cell : room_.view(other.node)) {
          taken[static_cast<std::size_t>(cell)] = 1;
        }
      }
    }
    const auto& known = known_[robot.group];
    const auto paths_m = room_.paths_m(robot.node, [&](std::size_t node) {
      return room_.cell(node) >= 0 && known[static_cast<std::size_t>(room_.cell(node))] != 0;
    });
    double best_per_s = 0.0;
    const std::size_t from = robot.node;
    for (std::size_t node = 0; node < room_.node_count(); ++node) {
      if (paths_m[node] == kNever || !room_.is_place(node)) {
        continue;
      }
      const double takes_s = paths_m[node] / params_.speed_m_per_s + params_.stop_s;
      const auto gain = std::ranges::count_if(
          room_.view(node), [&](int cell) { return taken[static_cast<std::size_t>(cell)] == 0; });
      if (static_cast<double>(gain) / takes_s > best_per_s) {
        best_per_s = static_cast<double>(gain) / takes_s;
        robot.node = node;
        robot.next_s = now_s + takes_s;
      }
    }
    robot.is_idle = robot.node == from && best_per_s == 0.0;
  }

  IdealTeamParams params_;
  IdealRoom room_;
  std::vector<IdealRobot> robots_;
  std::vector<std::vector<char>> known_;  ///< By group.
};

}  // namespace

std::optional<double> ideal_team_s(const RasterMap& floor,
                                   const std::vector<Eigen::Vector2d>& starts_m,
                                   const IdealTeamParams& params) {
  geometry::ParameterValidator("ideal team")
      .require(!starts_m.empty(), "it takes a start")
      .positive("view_m", params.view_m)
      .positive("stop_s", params.stop_s)
      .positive("speed_m_per_s", params.speed_m_per_s)
      .positive("robot_radius_m", params.robot_radius_m)
      .at_least("shared_m2", params.shared_m2, 0.0)
      .positive("enough_share", params.enough_share)
      .positive("cell_m", params.cell_m)
      .positive("place_m", params.place_m);
  return IdealTeam(floor, starts_m, params).run();
}

}  // namespace echomap::bench
