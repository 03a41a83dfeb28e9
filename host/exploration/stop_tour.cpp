// SPDX-License-Identifier: MIT
#include "host/exploration/stop_tour.hpp"

#include <algorithm>
#include <utility>
#include <variant>

#include "host/exploration/navigator.hpp"
#include "host/geometry/parameter_validator.hpp"
#include "host/mapping/raster_map.hpp"

namespace echomap::exploration {

StopTour::StopTour(const StopTourParams& params, std::vector<TourPlace> places)
    : params_(params), places_(std::move(places)), follower_(params.follower) {
  geometry::ParameterValidator("stop tour")
      .require(is_possible(params.sweep), "the sweep is impossible: check its range and its steps")
      .at_least("back_off_m", params.back_off_m, 0.0)
      .require(!places_.empty(), "a tour has one place or more")
      .require(std::all_of(places_.begin(),
                           places_.end(),
                           [](const TourPlace& place) { return place.position_m.allFinite(); }),
               "the position of a place must be finite");
}

StrategyProducts StopTour::products() const {
  StrategyProducts products;
  products.phases = places_.size();
  products.phases_reached = reached_;
  return products;
}

Motion StopTour::next(const pipeline::Snapshot& snapshot, MotionResult last) {
  plan_.end_motion(last);
  if (auto motion = recover(snapshot, last)) {
    return *motion;
  }
  if (auto motion = plan_.next()) {
    return *motion;
  }
  if (phase_ == Phase::kSensing) {
    if (!plan_.has_swept()) {
      return Finished{FinishReason::kCannotSense};
    }
    leave_place(true);
  }
  return drive_on(snapshot);
}

/// What stops the robot on its way stands between it and the place, which is given up. A motion
/// that fails for another reason is repeated, as long as the way may take.
std::optional<Motion> StopTour::recover(const pipeline::Snapshot& snapshot, MotionResult last) {
  if (last == MotionResult::kLifted) {
    return Finished{FinishReason::kLifted};
  }
  if (last == MotionResult::kTakenOver) {
    plan_ = {};
    phase_ = Phase::kSettingOff;
    return std::nullopt;
  }
  if (phase_ != Phase::kDriving || !is_stopped(snapshot, last)) {
    return std::nullopt;
  }
  leave_place(false);
  return Drive{-params_.back_off_m};
}

/// On along the way, and along the next one where a place is only passed.
Motion StopTour::drive_on(const pipeline::Snapshot& snapshot) {
  while (current_ < places_.size()) {
    if (phase_ == Phase::kSettingOff) {
      set_off(snapshot);
    }
    // NOLINTNEXTLINE(bugprone-unchecked-optional-access): it has set off
    const auto motion = follower_.next(snapshot.latest.T_map_robot, *costs_);
    if (motion && motions_left_ > 0) {
      --motions_left_;
      return *motion;
    }
    if (!motion && places_[current_].sweeps) {
      phase_ = Phase::kSensing;
      return plan_.begin(stop_sweep(
          params_.sweep, snapshot.stops, snapshot.latest.T_map_robot.heading_rad() > 0.0));
    }
    leave_place(!motion);
  }
  return Finished{reached_ == places_.size() ? FinishReason::kComplete
                                             : FinishReason::kWaypointsMissed};
}

void StopTour::set_off(const pipeline::Snapshot& snapshot) {
  const Eigen::Vector2d& here_m = snapshot.latest.T_map_robot.position_m();
  const Eigen::Vector2d& there_m = places_[current_].position_m;
  costs_.emplace(mapping::rasterize(*snapshot.grid), here_m, params_.costs);
  follower_.follow({here_m, there_m});
  motions_left_ = max_motions((there_m - here_m).norm(), params_.follower);
  phase_ = Phase::kDriving;
}

void StopTour::leave_place(bool was_reached) {
  reached_ += was_reached ? 1 : 0;
  ++current_;
  phase_ = Phase::kSettingOff;
}

}  // namespace echomap::exploration
