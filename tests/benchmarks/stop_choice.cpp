// SPDX-License-Identifier: MIT
#include "tests/benchmarks/stop_choice.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "hil_mock/runner/truth_map.hpp"
#include "hil_mock/world/ray_cast.hpp"

namespace echomap::bench {
namespace {

/// A look at a wall begins so far before it.
constexpr double kTargetSkinM = 0.01;

/// A piece of floor or of a wall that stops are to show.
struct Target {
  Eigen::Vector2d at_m = Eigen::Vector2d::Zero();
  /// Away from a wall, into the room; zero for floor.
  Eigen::Vector2d normal = Eigen::Vector2d::Zero();
  double worth = 0.0;  ///< Of the first view of it.
  int views = 0;
};

void add_floor(const runner::TruthMap& truth, double step_m, std::vector<Target>& targets) {
  const int stride = std::max(1, static_cast<int>(std::lround(step_m / truth.resolution_m)));
  for (int row = stride / 2; row < truth.height; row += stride) {
    for (int column = stride / 2; column < truth.width; column += stride) {
      if (truth.at(column, row) == runner::TruthCell::kFree) {
        const Eigen::Vector2d cell(column + 0.5, row + 0.5);
        targets.push_back(
            {Eigen::Vector2d(truth.origin_x_m, truth.origin_y_m) + truth.resolution_m * cell,
             Eigen::Vector2d::Zero(),
             step_m * step_m});
      }
    }
  }
}

void add_wall(const geometry::Segment& wall, double step_m, std::vector<Target>& targets) {
  const int pieces = std::max(1, static_cast<int>(std::lround(wall.length_m() / step_m)));
  for (int i = 0; i < pieces; ++i) {
    const Eigen::Vector2d at_m = wall.from_m + (i + 0.5) / pieces * (wall.to_m - wall.from_m);
    targets.push_back({at_m, geometry::left_normal(wall), wall.length_m() / pieces});
  }
}

std::vector<Target> targets_of(const world::FloorPlan& plan, const StopChoiceParams& params) {
  constexpr double kTruthCellM = 0.05;
  std::vector<Target> targets;
  add_floor(runner::draw_truth_map(plan, kTruthCellM), params.floor_step_m, targets);
  for (const world::Wall& wall : plan.still_walls()) {
    add_wall(wall.segment, params.wall_step_m, targets);
  }
  return targets;
}

bool shows(const world::FloorPlan& plan,
           const Eigen::Vector2d& stop_m,
           const Target& target,
           const StopChoiceParams& params) {
  const Eigen::Vector2d offset_m = stop_m - target.at_m;
  const double distance_m = offset_m.norm();
  const bool is_wall = !target.normal.isZero();
  if (distance_m > (is_wall ? params.wall_reach_m : params.floor_reach_m)) {
    return false;
  }
  if (is_wall && offset_m.dot(target.normal) < distance_m * std::cos(params.max_incidence_rad)) {
    return false;
  }
  return distance_m < kTargetSkinM ||
         world::sees(plan, target.at_m + kTargetSkinM * target.normal, stop_m);
}

/// What each candidate shows, by the targets' indices.
std::vector<std::vector<std::uint32_t>> views_of(const world::FloorPlan& plan,
                                                 const std::vector<Eigen::Vector2d>& candidates_m,
                                                 const std::vector<Target>& targets,
                                                 const StopChoiceParams& params) {
  std::vector<std::vector<std::uint32_t>> views(candidates_m.size());
  for (std::size_t i = 0; i < candidates_m.size(); ++i) {
    for (std::uint32_t target = 0; target < targets.size(); ++target) {
      if (shows(plan, candidates_m[i], targets[target], params)) {
        views[i].push_back(target);
      }
    }
  }
  return views;
}

double gain(const std::vector<std::uint32_t>& view, const std::vector<Target>& targets, int views) {
  double sum = 0.0;
  for (const std::uint32_t i : view) {
    const Target& target = targets[i];
    sum += target.views < views ? std::ldexp(target.worth, -target.views) : 0.0;
  }
  return sum;
}

double distance_to_nearest_m(const Eigen::Vector2d& place_m,
                             const std::vector<Eigen::Vector2d>& stops_m) {
  double nearest_m = std::numeric_limits<double>::infinity();
  for (const Eigen::Vector2d& stop_m : stops_m) {
    nearest_m = std::min(nearest_m, (stop_m - place_m).norm());
  }
  return nearest_m;
}

/// Adds the candidate that is farthest from all stops, as long as it is farther than `max_gap_m`.
void fill_gaps(const std::vector<Eigen::Vector2d>& candidates_m,
               double max_gap_m,
               std::size_t max_stops,
               std::vector<Eigen::Vector2d>& stops_m) {
  while (stops_m.size() < max_stops) {
    const Eigen::Vector2d* farthest = nullptr;
    double gap_m = max_gap_m;
    for (const Eigen::Vector2d& place_m : candidates_m) {
      const double off_m = distance_to_nearest_m(place_m, stops_m);
      if (off_m > gap_m) {
        farthest = &place_m;
        gap_m = off_m;
      }
    }
    if (farthest == nullptr) {
      return;
    }
    stops_m.push_back(*farthest);
  }
}

}  // namespace

std::vector<Eigen::Vector2d> choose_stops(const world::FloorPlan& plan,
                                          const std::vector<Eigen::Vector2d>& candidates_m,
                                          const Eigen::Vector2d& first_m,
                                          const StopChoiceParams& params) {
  const double side_m = std::sqrt(std::abs(geometry::signed_area_m2(plan.room_m())));
  const double min_gain = params.min_gain_per_side_m * side_m;
  std::vector<Target> targets = targets_of(plan, params);
  const auto views = views_of(plan, candidates_m, targets, params);
  std::vector<Eigen::Vector2d> stops_m{first_m};
  for (Target& target : targets) {
    target.views = shows(plan, first_m, target, params) ? 1 : 0;
  }
  while (stops_m.size() < params.max_stops) {
    std::size_t best = 0;
    double best_gain = min_gain;
    for (std::size_t i = 0; i < candidates_m.size(); ++i) {
      const double its_gain = gain(views[i], targets, params.views);
      if (its_gain > best_gain &&
          distance_to_nearest_m(candidates_m[i], stops_m) >= params.apart_share * side_m) {
        best = i;
        best_gain = its_gain;
      }
    }
    if (best_gain == min_gain) {
      break;
    }
    stops_m.push_back(candidates_m[best]);
    for (const std::uint32_t target : views[best]) {
      ++targets[target].views;
    }
  }
  fill_gaps(candidates_m, params.max_gap_share * side_m, params.max_stops, stops_m);
  return stops_m;
}

}  // namespace echomap::bench
