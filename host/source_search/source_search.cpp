// SPDX-License-Identifier: MIT
#include "host/source_search/source_search.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "host/exploration/frontier_search.hpp"
#include "host/geometry/parameter_validator.hpp"

namespace echomap::source_search {

using exploration::Finished;
using exploration::FinishReason;
using exploration::Motion;
using exploration::MotionResult;
using exploration::Viewpoint;

namespace {

/// So near to it the robot is at its goal.
constexpr double kArrivedM = 0.1;
/// A way may cost so many times its length: floor beside walls is dearer.
constexpr double kWaySlack = 3.0;
/// Shares of the golden ratio, so that samples differ from decision to decision.
constexpr double kGoldenShare = 0.6180339887498949;

bool is_same(const FieldReading& one, const FieldReading& other) {
  constexpr double kMovedM = 0.02;
  return (one.at_m - other.at_m).norm() < kMovedM && one.value == other.value;
}

}  // namespace

SourceSearch::SourceSearch(const SourceSearchParams& params)
    : params_(params),
      navigator_(params.frontier.navigator),
      choice_(params.choice),
      rest_(params.frontier) {
  geometry::ParameterValidator("source search")
      .nonnegative_finite("beyond_m", params.beyond_m)
      .nonnegative_finite("nats_per_unknown_m2", params.nats_per_unknown_m2)
      .positive_finite("rethink_s", params.rethink_s)
      .positive("max_goals", params.max_goals)
      .positive_finite("frontier.gain.depth_m", params.frontier.gain.depth_m)
      .at_least("belief.grid.unknown_reach_m",
                params.belief.grid.unknown_reach_m,
                params.explores ? params.frontier.gain.depth_m : 0.0);
}

void SourceSearch::set_readings(std::vector<FieldReading> readings) {
  const std::size_t same = std::min(known_readings_, readings.size());
  are_readings_moved_ = are_readings_moved_ || readings.size() < known_readings_ ||
                        !std::equal(readings_.begin(),
                                    readings_.begin() + static_cast<std::ptrdiff_t>(same),
                                    readings.begin(),
                                    is_same);
  readings_ = std::move(readings);
}

void SourceSearch::set_company(const exploration::Company& company) {
  navigator_.set_standing(company.standing);
  exploration::Company others;
  others.standing = company.standing;
  rest_.set_company(std::move(others));
}

Motion SourceSearch::next(const pipeline::Snapshot& snapshot, MotionResult last) {
  if (explores_rest_) {
    return explore_rest(snapshot, last);
  }
  scan_.end_motion(last);
  if (auto motion = recover(snapshot, last)) {
    return *motion;
  }
  if (auto motion = scan_.next()) {
    return *motion;
  }
  if (phase_ == Phase::kStarting && params_.explores) {
    return begin_sweep(snapshot);
  }
  if (phase_ != Phase::kDriving || has_to_think(snapshot) || has_become_sure()) {
    return decide(snapshot);
  }
  return drive_on(snapshot);
}

/// Takes in what has come on the way: a claim is tested with each reading, lest the robot pass 95 %
/// unnoticed.
bool SourceSearch::has_become_sure() {
  if (are_readings_moved_ || known_readings_ == readings_.size()) {
    return false;
  }
  take_readings();
  const SourceVerdict verdict = belief_->estimate().verdict;
  return verdict == SourceVerdict::kFound || (verdict == SourceVerdict::kNone && !is_look_);
}

/// Whether no reading adds anything: there is none as far as the map goes, or the source is where
/// no path leads.
bool SourceSearch::has_to_see_more(const pipeline::Snapshot& snapshot) const {
  const SourceEstimate& estimate = belief_->estimate();
  if (estimate.is_to_confirm) {
    return !choose_confirmation(snapshot);
  }
  return estimate.none_probability + estimate.unseen_probability >=
         params_.belief.claim_probability;
}

/// The nearest place, by its path, from which a reading confirms or refutes the most probable place
/// of the source.
std::optional<Viewpoint> SourceSearch::choose_confirmation(
    const pipeline::Snapshot& snapshot) const {
  const exploration::CostGrid& costs = navigator_.costs();
  exploration::TravelField travel;
  travel.search(costs, costs.cell_at(snapshot.latest.T_map_robot.position_m()));
  const Eigen::Vector2d& place_m = belief_->estimate().best_m;
  const geometry::CellIndex low = costs.cell_at(place_m.array() - params_.belief.confirm_m);
  const geometry::CellIndex high = costs.cell_at(place_m.array() + params_.belief.confirm_m);
  std::optional<Viewpoint> nearest;
  for (std::int32_t y = low.y; y <= high.y; ++y) {
    for (std::int32_t x = low.x; x <= high.x; ++x) {
      const auto cost_m = costs.is_open({x, y}) ? travel.cost_m({x, y}) : std::nullopt;
      if (cost_m && (!nearest || *cost_m < nearest->cost_m) &&
          belief_->confirms(costs.center_m({x, y}))) {
        nearest = Viewpoint{costs.center_m({x, y}), {}, *cost_m, 0.0};
      }
    }
  }
  return nearest;
}

/// As strategy `frontier`, until nothing is left to see, or something was read: that is noticed on
/// the way, not amid a sweep.
Motion SourceSearch::explore_rest(const pipeline::Snapshot& snapshot, MotionResult last) {
  if (rest_.goal()) {
    update(snapshot);
    if (!has_to_see_more(snapshot)) {
      return end_rest(snapshot);
    }
  }
  const Motion motion = rest_.next(snapshot, last);
  const auto* finished = std::get_if<Finished>(&motion);
  if (finished != nullptr && finished->reason == FinishReason::kComplete) {
    is_explored_ = true;
    return end_rest(snapshot);
  }
  plan_readings_.clear();
  if (const auto goal = rest_.goal()) {
    plan_readings_.push_back({goal->at_m, params_.choice.dwell_s});
  }
  return motion;
}

Motion SourceSearch::end_rest(const pipeline::Snapshot& snapshot) {
  explores_rest_ = false;
  phase_ = Phase::kBackingOff;
  stops_of_map_.reset();
  return decide(snapshot);
}

/// As exploration::Frontier.
std::optional<Motion> SourceSearch::recover(const pipeline::Snapshot& snapshot, MotionResult last) {
  if (last == MotionResult::kLifted || last == MotionResult::kTakenOver) {
    scan_ = {};
    phase_ = Phase::kStarting;
    is_explored_ = false;
  }
  if (last == MotionResult::kTakenOver) {
    navigator_.forget_failures();
    return std::nullopt;
  }
  auto motion = navigator_.recover(snapshot, last, phase_ == Phase::kDriving);
  if (motion) {
    phase_ = Phase::kBackingOff;
    stops_of_map_.reset();
  }
  return motion;
}

void SourceSearch::reconsider() {
  if (explores_rest_) {
    rest_.reconsider();
  } else if (phase_ == Phase::kDriving) {
    phase_ = Phase::kBackingOff;
    goal_m_.reset();
    stops_of_map_.reset();
  }
}

exploration::Intent SourceSearch::intent() const {
  if (explores_rest_) {
    return rest_.intent();
  }
  if (!goal_m_) {
    return {};
  }
  return {is_look_ ? exploration::IntentKind::kFrontier : exploration::IntentKind::kStrategy,
          exploration::WeighedPlace{*goal_m_, 0.0, 0.0},
          {}};
}

void SourceSearch::set_map(const pipeline::Snapshot& snapshot) {
  const double reach_m = params_.explores ? params_.belief.grid.unknown_reach_m : 0.0;
  map_ = navigator_.map_of(snapshot, std::max(params_.frontier.gain.depth_m, reach_m));
  set_ways(snapshot);
  stops_of_map_ = snapshot.stops;
  const SourceFloor floor = floor_of(snapshot);
  if (!belief_) {
    belief_.emplace(params_.belief, floor);
  }
  belief_->rebuild(floor, readings_);
  known_readings_ = readings_.size();
  are_readings_moved_ = false;
}

/// Once all is explored, nothing is expected beyond it.
SourceFloor SourceSearch::floor_of(const pipeline::Snapshot& snapshot) const {
  if (!params_.explores) {
    return {*map_};
  }
  SourceFloor floor(*map_, view_gain(snapshot));
  floor.position_stddev_m = snapshot.position_stddev_m.value_or(0.0);
  if (!is_explored_) {
    floor.unseen_m2 = floor_beyond_m2(floor,
                                      params_.belief.grid.unknown_reach_m,
                                      params_.frontier.gain.depth_m,
                                      params_.beyond_m);
  }
  return floor;
}

exploration::ViewGain SourceSearch::view_gain(const pipeline::Snapshot& snapshot) const {
  return {*map_,
          exploration::views_of(*snapshot.scans),
          snapshot.features->unobserved,
          params_.frontier.gain};
}

void SourceSearch::set_ways(const pipeline::Snapshot& snapshot) {
  navigator_.set_map(*map_, snapshot);
  lattice_.emplace(navigator_.costs(), params_.choice.spacing_m);
}

void SourceSearch::update(const pipeline::Snapshot& snapshot) {
  if (stops_of_map_ != snapshot.stops || are_readings_moved_) {
    set_map(snapshot);
    return;
  }
  take_readings();
  // The robot stands on floor, whatever the map has there: otherwise no path would lead away.
  const Eigen::Vector2d here_m = snapshot.latest.T_map_robot.position_m();
  if (!navigator_.costs().is_open(navigator_.costs().cell_at(here_m))) {
    set_ways(snapshot);
  }
}

void SourceSearch::take_readings() {
  if (known_readings_ < readings_.size()) {
    belief_->add(std::span(readings_).subspan(known_readings_));
    known_readings_ = readings_.size();
  }
}

bool SourceSearch::has_to_think(const pipeline::Snapshot& snapshot) const {
  const std::chrono::duration<double> since = snapshot.latest.stamp - thought_at_;
  return !is_look_ && known_readings_ < readings_.size() && since.count() >= params_.rethink_s;
}

Motion SourceSearch::decide(const pipeline::Snapshot& snapshot) {
  if (phase_ == Phase::kSensing && !scan_.has_swept()) {
    return Finished{FinishReason::kCannotSense};
  }
  update(snapshot);
  thought_at_ = snapshot.latest.stamp;
  const auto look = params_.explores ? choose_look(snapshot) : std::nullopt;
  const SourceVerdict verdict = belief_->estimate().verdict;
  if (verdict == SourceVerdict::kFound ||
      (verdict == SourceVerdict::kNone && !look && (is_explored_ || !params_.explores))) {
    plan_readings_.clear();
    has_ended_ = true;
    return Finished{FinishReason::kComplete};
  }
  const bool is_stuck = params_.explores && !look && has_to_see_more(snapshot);
  if (is_stuck && is_explored_) {
    return Finished{FinishReason::kNowhereToGo};
  }
  if (is_stuck) {
    explores_rest_ = true;
    rest_.reconsider();
    return explore_rest(snapshot, MotionResult::kReached);
  }
  if (++goals_ > params_.max_goals) {
    return Finished{FinishReason::kStopLimit};
  }
  const auto cost_m = choose_goal(snapshot, look);
  if (!cost_m) {
    return Finished{FinishReason::kNowhereToGo};
  }
  const geometry::Pose2& T_map_robot = snapshot.latest.T_map_robot;
  const bool is_here = (*goal_m_ - T_map_robot.position_m()).norm() < kArrivedM;
  navigator_.follow_path_to(T_map_robot, *goal_m_, is_here ? 0.0 : *cost_m);
  phase_ = Phase::kDriving;
  return drive_on(snapshot);
}

/// Answers what the way there may cost.
std::optional<double> SourceSearch::choose_goal(const pipeline::Snapshot& snapshot,
                                                const std::optional<Viewpoint>& look) {
  const Eigen::Vector2d here_m = snapshot.latest.T_map_robot.position_m();
  const bool is_under_way = phase_ == Phase::kDriving && !is_look_;
  const auto confirmation =
      belief_->estimate().is_to_confirm ? choose_confirmation(snapshot) : std::nullopt;
  if (confirmation) {
    is_look_ = false;
    goal_m_ = confirmation->at_m;
    goal_dwell_s_ = params_.choice.dwell_s;
    plan_readings_ = {{confirmation->at_m, goal_dwell_s_}};
    return confirmation->cost_m;
  }
  const auto plan = choice_.choose(*belief_,
                                   navigator_.costs(),
                                   *lattice_,
                                   here_m,
                                   others_,
                                   is_under_way ? goal_m_ : std::nullopt,
                                   std::fmod(static_cast<double>(goals_) * kGoldenShare, 1.0));
  const double look_per_s = look ? params_.nats_per_unknown_m2 * look->gain_per_s : 0.0;
  is_look_ = look && (!plan || look_per_s > plan->gain_per_s);
  if (is_look_) {
    goal_m_ = look->at_m;
    goal_dwell_s_ = 0.0;
    plan_readings_ = {{look->at_m, params_.choice.dwell_s}};
    return look->cost_m;
  }
  if (!plan) {
    return std::nullopt;
  }
  goal_m_ = plan->goal_m;
  goal_dwell_s_ = plan->dwell_s;
  plan_readings_ = plan->readings;
  return kWaySlack * (plan->time_s - plan->dwell_s) * params_.choice.speed_m_per_s;
}

std::optional<Viewpoint> SourceSearch::choose_look(const pipeline::Snapshot& snapshot) const {
  const geometry::Pose2& T_map_robot = snapshot.latest.T_map_robot;
  const exploration::ViewGain gain = view_gain(snapshot);
  const auto frontiers =
      exploration::find_frontiers(*map_, map_->cell_at(T_map_robot.position_m()));
  exploration::TravelField travel;
  travel.search(navigator_.costs(), navigator_.costs().cell_at(T_map_robot.position_m()));
  const auto weighed = exploration::weigh_viewpoints(
      navigator_.costs(), travel, frontiers, gain, T_map_robot, params_.frontier.viewpoints);
  return weighed.empty() ? std::nullopt : std::optional(weighed.front());
}

/// On along the way; at its end it looks around, or stands and counts.
Motion SourceSearch::drive_on(const pipeline::Snapshot& snapshot) {
  if (const auto motion = navigator_.next(snapshot.latest.T_map_robot)) {
    return *motion;
  }
  navigator_.forget_failures();
  if (is_look_) {
    return begin_sweep(snapshot);
  }
  phase_ = Phase::kDwelling;
  return exploration::Stand{std::max(goal_dwell_s_, 1.0)};
}

Motion SourceSearch::begin_sweep(const pipeline::Snapshot& snapshot) {
  phase_ = Phase::kSensing;
  const double heading_rad = snapshot.latest.T_map_robot.heading_rad();
  return scan_.begin(
      exploration::stop_sweep(params_.frontier.sweep, snapshot.stops, heading_rad > 0.0));
}

}  // namespace echomap::source_search
