// SPDX-License-Identifier: MIT
#include "host/exploration/active_localization.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <variant>
#include <vector>

#include "host/exploration/view_gain.hpp"
#include "host/geometry/parameter_validator.hpp"

namespace echomap::exploration {
namespace {

using geometry::Pose2;

double distance_to_nearest_stop_m(const Eigen::Vector2d& place_m,
                                  const pipeline::Snapshot& snapshot) {
  double nearest_m = std::numeric_limits<double>::infinity();
  for (const PastView& view : views_of(*snapshot.scans)) {
    nearest_m = std::min(nearest_m, (view.from_m - place_m).norm());
  }
  return nearest_m;
}

}  // namespace

ActiveLocalization::ActiveLocalization(const ActiveLocalizationParams& params, GoalUtility utility)
    : params_(params), navigator_(params.navigator), utility_(std::move(utility)) {
  geometry::ParameterValidator("active localization")
      .require(is_possible(params.sweep), "the sweep is impossible: check its range and its steps")
      .positive("lattice_m", params.lattice_m)
      .positive("max_places", params.max_places)
      .positive("min_drive_m", params.min_drive_m)
      .positive("new_view_m", params.new_view_m)
      .positive("min_utility", params.min_utility)
      .positive("stop_s", params.stop_s)
      .positive("speed_m_per_s", params.speed_m_per_s);
}

Motion ActiveLocalization::next(const pipeline::Snapshot& snapshot, MotionResult last) {
  plan_.end_motion(last);
  if (last == MotionResult::kTakenOver) {
    return begin_sweep(snapshot);
  }
  if (auto motion = recover(snapshot, last)) {
    return *motion;
  }
  if (auto motion = plan_.next()) {
    return *motion;
  }
  switch (phase_) {
    case Phase::kStarting:
      if (snapshot.stops == 0) {
        return begin_sweep(snapshot);
      }
      break;
    case Phase::kDriving:
      return drive_on(snapshot);
    case Phase::kSensing:
    case Phase::kBackingOff:
      break;
  }
  return decide(snapshot);
}

/// A stop whose sweeps fail is no way that fails.
std::optional<Motion> ActiveLocalization::recover(const pipeline::Snapshot& snapshot,
                                                  MotionResult last) {
  if (phase_ == Phase::kSensing) {
    return std::nullopt;
  }
  auto motion = navigator_.recover(snapshot, last, phase_ == Phase::kDriving);
  phase_ = motion ? Phase::kBackingOff : phase_;
  return motion;
}

Motion ActiveLocalization::decide(const pipeline::Snapshot& snapshot) {
  if (phase_ == Phase::kSensing) {
    if (!plan_.has_swept()) {
      return Finished{FinishReason::kCannotSense};
    }
    navigator_.forget_failures();
  }
  navigator_.set_map(navigator_.map_of(snapshot, 0.0), snapshot);
  const auto place = choose_place(snapshot);
  if (!place) {
    return Finished{FinishReason::kNowhereToGo};
  }
  navigator_.follow_path_to(snapshot.latest.T_map_robot, place->at_m, place->cost_m);
  goal_ = {place->at_m, 0.0, place->cost_m};
  phase_ = Phase::kDriving;
  return drive_on(snapshot);
}

Intent ActiveLocalization::intent() const {
  return phase_ == Phase::kDriving ? Intent{IntentKind::kTellApart, goal_, {}}
                                   : Intent{IntentKind::kSweep, std::nullopt, {}};
}

std::optional<ActiveLocalization::Place> ActiveLocalization::choose_place(
    const pipeline::Snapshot& snapshot) const {
  const CostGrid& costs = navigator_.costs();
  const auto step =
      std::max(1, static_cast<std::int32_t>(std::lround(params_.lattice_m / costs.resolution_m())));
  std::vector<Place> places;
  for (std::int32_t y = 0; y < costs.rows(); y += step) {
    for (std::int32_t x = 0; x < costs.columns(); x += step) {
      const auto cost_m = navigator_.travel().cost_m({x, y});
      if (cost_m && *cost_m >= params_.min_drive_m) {
        places.push_back({costs.center_m({x, y}), *cost_m});
      }
    }
  }
  std::stable_sort(places.begin(), places.end(), [](const Place& one, const Place& other) {
    return one.cost_m < other.cost_m;
  });
  places.resize(std::min(places.size(), params_.max_places));
  std::optional<Place> best;
  double most_per_s = 0.0;
  for (const Place& place : places) {
    const double per_s = utility_per_s(place, snapshot);
    if (per_s > most_per_s) {
      most_per_s = per_s;
      best = place;
    }
  }
  return best;
}

double ActiveLocalization::utility_per_s(const Place& place,
                                         const pipeline::Snapshot& snapshot) const {
  const Pose2& T_map_robot = snapshot.latest.T_map_robot;
  const Eigen::Vector2d offset_m = place.at_m - T_map_robot.position_m();
  const Pose2 T_map_goal(place.at_m.x(), place.at_m.y(), std::atan2(offset_m.y(), offset_m.x()));
  const double utility = utility_(T_map_robot.inverse() * T_map_goal);
  const double is_new =
      std::min(1.0, distance_to_nearest_stop_m(place.at_m, snapshot) / params_.new_view_m);
  return (utility + params_.min_utility) * is_new /
         (params_.stop_s + place.cost_m / params_.speed_m_per_s);
}

/// On along the way; where it ends, or has taken too long, the sweep.
Motion ActiveLocalization::drive_on(const pipeline::Snapshot& snapshot) {
  if (const auto motion = navigator_.next(snapshot.latest.T_map_robot)) {
    return *motion;
  }
  return begin_sweep(snapshot);
}

Motion ActiveLocalization::begin_sweep(const pipeline::Snapshot& snapshot) {
  phase_ = Phase::kSensing;
  return plan_.begin(round_sweep(params_.sweep, snapshot.latest.T_map_robot.heading_rad() > 0.0));
}

}  // namespace echomap::exploration
