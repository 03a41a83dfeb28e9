// SPDX-License-Identifier: MIT
#include "host/exploration/active_localization.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <variant>
#include <vector>

#include "host/geometry/parameter_validator.hpp"

namespace echomap::exploration {
namespace {

using geometry::Pose2;

/// From the nearest stop of the map.
double apart_m(const Eigen::Vector2d& place_m, const pipeline::Snapshot& snapshot) {
  double nearest_m = std::numeric_limits<double>::infinity();
  for (const mapping::Scan& scan : *snapshot.scans) {
    const Eigen::Vector2d& stop_m = scan.front().T_map_robot.position_m();
    nearest_m = std::min(nearest_m, (stop_m - place_m).norm());
  }
  return nearest_m;
}

}  // namespace

ActiveLocalization::ActiveLocalization(const ActiveLocalizationParams& params)
    : params_(params), navigator_(params.navigator) {
  geometry::ParameterValidator("active localization")
      .require(is_possible(params.sweep), "the sweep is impossible: check its range and its steps")
      .positive("lattice_m", params.lattice_m)
      .positive("max_places", params.max_places)
      .positive("min_drive_m", params.min_drive_m)
      .positive("new_view_m", params.new_view_m)
      .positive("least_worth", params.least_worth)
      .positive("stop_s", params.stop_s)
      .positive("speed_m_per_s", params.speed_m_per_s)
      .positive("max_failures", params.max_failures);
}

Motion ActiveLocalization::next(const pipeline::Snapshot& snapshot, MotionResult last) {
  sweeps_done_ += sweeping_ && last == MotionResult::kReached ? 1 : 0;
  sweeping_ = false;
  if (auto motion = recover(snapshot, last)) {
    return *motion;
  }
  if (!plan_.empty()) {
    return take_planned();
  }
  switch (phase_) {
    case Phase::kStarting:
      if (snapshot.stops == 0) {
        plan_sweep(snapshot);
        return take_planned();
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

std::optional<Motion> ActiveLocalization::recover(const pipeline::Snapshot& snapshot,
                                                  MotionResult last) {
  const bool pushes = phase_ == Phase::kDriving && is_stopped(snapshot, MotionResult::kReached);
  if (last == MotionResult::kReached && !pushes) {
    return std::nullopt;
  }
  if (++failures_ > params_.max_failures) {
    return Finished{FinishReason::kNowhereToGo};
  }
  if (phase_ != Phase::kDriving || !is_stopped(snapshot, last)) {
    return std::nullopt;
  }
  phase_ = Phase::kBackingOff;
  return navigator_.back_off(snapshot);
}

Motion ActiveLocalization::decide(const pipeline::Snapshot& snapshot) {
  if (phase_ == Phase::kSensing) {
    if (sweeps_done_ == 0) {
      return Finished{FinishReason::kCannotSense};
    }
    failures_ = 0;
  }
  navigator_.survey(navigator_.map_of(snapshot, 0.0), snapshot);
  const auto place = choose_place(snapshot);
  if (!place) {
    return Finished{FinishReason::kNowhereToGo};
  }
  navigator_.set_off(snapshot.latest.T_map_robot, place->at_m, place->cost_m);
  phase_ = Phase::kDriving;
  return drive_on(snapshot);
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
    const double per_s = worth_per_s(place, snapshot);
    if (per_s > most_per_s) {
      most_per_s = per_s;
      best = place;
    }
  }
  return best;
}

double ActiveLocalization::worth_per_s(const Place& place,
                                       const pipeline::Snapshot& snapshot) const {
  const Pose2& T_map_robot = snapshot.latest.T_map_robot;
  const Eigen::Vector2d offset_m = place.at_m - T_map_robot.position_m();
  const Pose2 T_map_goal(place.at_m.x(), place.at_m.y(), std::atan2(offset_m.y(), offset_m.x()));
  const double told = telling_ ? telling_(T_map_robot.inverse() * T_map_goal) : 0.0;
  const double is_new = std::min(1.0, apart_m(place.at_m, snapshot) / params_.new_view_m);
  return (told + params_.least_worth) * is_new /
         (params_.stop_s + place.cost_m / params_.speed_m_per_s);
}

/// On along the way; where it ends, or has taken too long, the sweep.
Motion ActiveLocalization::drive_on(const pipeline::Snapshot& snapshot) {
  if (const auto motion = navigator_.next(snapshot.latest.T_map_robot)) {
    return *motion;
  }
  plan_sweep(snapshot);
  return take_planned();
}

void ActiveLocalization::plan_sweep(const pipeline::Snapshot& snapshot) {
  phase_ = Phase::kSensing;
  sweeps_done_ = 0;
  plan_ = round_sweep(params_.sweep, snapshot.latest.T_map_robot.heading_rad() > 0.0);
}

Motion ActiveLocalization::take_planned() {
  Motion motion = plan_.front();
  plan_.pop_front();
  sweeping_ = std::holds_alternative<Sweep>(motion);
  return motion;
}

}  // namespace echomap::exploration
