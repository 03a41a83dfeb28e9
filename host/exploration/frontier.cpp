// SPDX-License-Identifier: MIT
#include "host/exploration/frontier.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "host/exploration/coverage.hpp"
#include "host/exploration/frontier_search.hpp"
#include "host/exploration/planning_map.hpp"
#include "host/exploration/unwinding_turn.hpp"
#include "host/geometry/angle.hpp"
#include "host/geometry/parameter_validator.hpp"
#include "host/mapping/raster_map.hpp"

namespace echomap::exploration {

namespace {

using geometry::CellIndex;
using geometry::Pose2;
using mapping::CellState;
using mapping::RasterMap;

constexpr BestView kAllRound{0.0, 0.0, geometry::kFullTurnRad};
/// Of the places that were weighed, so many are told, and so far apart.
constexpr std::size_t kToldPlaces = 8;
constexpr double kToldApartM = 0.6;

WeighedPlace weighed_place(const Viewpoint& viewpoint) {
  return {viewpoint.at_m, viewpoint.view.gain_m2, viewpoint.cost_m};
}

std::vector<WeighedPlace> told_places(const std::vector<Viewpoint>& viewpoints) {
  std::vector<WeighedPlace> told;
  for (const Viewpoint& viewpoint : viewpoints) {
    const bool is_apart = std::none_of(told.begin(), told.end(), [&](const WeighedPlace& place) {
      return (place.at_m - viewpoint.at_m).norm() < kToldApartM;
    });
    if (is_apart && told.size() < kToldPlaces) {
      told.push_back(weighed_place(viewpoint));
    }
  }
  return told;
}

void validate(const FrontierParams& params) {
  geometry::ParameterValidator("frontier")
      .require(is_possible(params.sweep), "the sweep is impossible: check its range and its steps")
      .positive("viewpoints.min_gain_m2", params.viewpoints.min_gain_m2)
      .positive("fine_gain_m2", params.fine_gain_m2)
      .at_least("enough_share", params.enough_share, 0.0)
      .at_least("openings_apart_m", params.openings_apart_m, 0.0)
      .positive("openings.step_m", params.openings.step_m)
      .positive("openings.half_width_m", params.openings.half_width_m)
      .positive("openings.far_m", params.openings.far_m)
      .positive("doors.min_width_m", params.doors.min_width_m)
      .positive("doors.told_apart_m", params.doors.told_apart_m)
      .positive("doors.max_distance_m", params.doors.max_distance_m)
      .at_least("doors.apart_m", params.doors.apart_m, 0.0)
      .positive("max_stops", params.max_stops)
      .at_least("contest_m", params.contest_m, 0.0)
      .at_least("outbid", params.outbid, 1.0);
}

}  // namespace

Frontier::Frontier(const FrontierParams& params)
    : params_(params), navigator_(params.navigator), loops_(params.loops) {
  validate(params);
}

Motion Frontier::next(const pipeline::Snapshot& snapshot, MotionResult last) {
  plan_.end_motion(last);
  if (auto motion = recover(snapshot, last)) {
    return *motion;
  }
  if (auto motion = plan_.next()) {
    return *motion;
  }
  switch (phase_) {
    case Phase::kStarting:
      return begin_sweep(snapshot, kAllRound);
    case Phase::kDriving:
      return drive_on(snapshot);
    case Phase::kBackingOff:
      if (is_beside_goal(snapshot.latest.T_map_robot)) {
        // NOLINTNEXTLINE(bugprone-unchecked-optional-access): it is beside it
        return begin_sweep(snapshot, goal_->view);
      }
      break;
    case Phase::kSensing:
    case Phase::kDeciding:
      break;
  }
  return decide(snapshot);
}

/// What stopped a move stands before the robot: it is kept, and the robot backs off. A lifted robot
/// starts again where it was put down.
std::optional<Motion> Frontier::recover(const pipeline::Snapshot& snapshot, MotionResult last) {
  if (last == MotionResult::kLifted || last == MotionResult::kTakenOver) {
    plan_ = {};
    phase_ = Phase::kStarting;
  }
  if (last == MotionResult::kTakenOver) {
    navigator_.forget_failures();
    return std::nullopt;
  }
  auto motion = navigator_.recover(snapshot, last, phase_ == Phase::kDriving);
  if (motion && phase_ == Phase::kDriving) {
    end_try_of_door();
    if (goal_ && goal_kind_ == IntentKind::kOpening) {
      ++opening_at(goal_->at_m).bumps;
    }
  }
  phase_ = motion ? Phase::kBackingOff : phase_;
  return motion;
}

Intent Frontier::intent() const {
  const bool is_on_the_way = phase_ == Phase::kDriving || phase_ == Phase::kBackingOff;
  if (!goal_ || !is_on_the_way) {
    return {IntentKind::kSweep, std::nullopt, weighed_};
  }
  return {goal_kind_, weighed_place(*goal_), weighed_};
}

void Frontier::set_company(Company company) {
  navigator_.set_standing(company.standing);
  company_ = std::move(company);
}

std::optional<Viewpoint> Frontier::goal() const {
  return phase_ == Phase::kDriving ? goal_ : std::nullopt;
}

void Frontier::reconsider() {
  if (phase_ == Phase::kDriving || !goal_) {
    phase_ = Phase::kDeciding;
  }
}

std::optional<FinishReason> Frontier::reason_to_finish(const pipeline::Snapshot& snapshot) {
  if (phase_ == Phase::kSensing && !plan_.has_swept()) {
    return FinishReason::kCannotSense;
  }
  if (snapshot.stops >= params_.max_stops) {
    return FinishReason::kStopLimit;
  }
  return std::nullopt;
}

Motion Frontier::decide(const pipeline::Snapshot& snapshot) {
  if (const auto reason = reason_to_finish(snapshot)) {
    return Finished{*reason};
  }
  if (phase_ == Phase::kSensing) {
    loops_.add_stop(snapshot);
    navigator_.forget_failures();
    if (snapshot.last_scan_fault == mapping::ScanFault::kElsewhere) {
      refused_m_.push_back(snapshot.latest.T_map_robot.position_m());
    }
  }
  const Pose2& T_map_robot = snapshot.latest.T_map_robot;
  const pipeline::Snapshot known = with_company(snapshot, company_);
  const RasterMap map = navigator_.map_of(known, params_.gain.depth_m);
  navigator_.set_map(map, known);
  goal_ = choose_goal(map, known, snapshot);
  if (!goal_) {
    return Finished{FinishReason::kComplete};
  }
  navigator_.follow_path_to(T_map_robot, goal_->at_m, goal_->cost_m);
  phase_ = Phase::kDriving;
  return drive_on(snapshot);
}

/// A look, and before one that is out of sight of known walls the stop that makes the position
/// known again; without a look an opening, a finer look, or one at what may be a door. The robot's
/// own stops are in `own`.
std::optional<Viewpoint> Frontier::choose_goal(const RasterMap& map,
                                               const pipeline::Snapshot& known,
                                               const pipeline::Snapshot& own) {
  door_m_.reset();
  if (const auto look = choose_look(map, known, params_.viewpoints.min_gain_m2)) {
    const auto stop = loops_.choose(own, look->at_m, navigator_.travel(), map);
    goal_kind_ = stop ? IntentKind::kKnownWalls : IntentKind::kFrontier;
    return stop ? Viewpoint{stop->at_m, kAllRound, stop->cost_m, 0.0} : look;
  }
  if (auto opening = choose_opening(map, known)) {
    goal_kind_ = IntentKind::kOpening;
    return opening;
  }
  goal_kind_ = IntentKind::kFrontier;
  const auto fine =
      has_enough(known) ? std::nullopt : choose_look(map, known, params_.fine_gain_m2);
  return fine ? fine : choose_door(map, known);
}

/// At the end, so that no room is left behind a door that was taken for a wall.
std::optional<Viewpoint> Frontier::choose_door(const RasterMap& map,
                                               const pipeline::Snapshot& snapshot) {
  const auto doors =
      possible_doors(map, snapshot.features->unheard, views_of(*snapshot.scans), params_.doors);
  const auto stand =
      nearest_door_stand(map, doors, navigator_.travel(), tried_doors_m_, params_.doors);
  if (!stand) {
    return std::nullopt;
  }
  navigator_.forget_failures();
  door_m_ = stand->middle_m;
  return Viewpoint{stand->at_m, kAllRound, stand->cost_m, 0.0};
}

/// Of those that others have promised, the ones that this robot does not outbid are left to them.
std::optional<Viewpoint> Frontier::choose_look(const RasterMap& map,
                                               const pipeline::Snapshot& snapshot,
                                               double min_gain_m2) {
  std::vector<PastView> views = views_of(*snapshot.scans);
  for (const Eigen::Vector2d& place_m : refused_m_) {
    views.push_back({place_m, 0.0, 0.0});
  }
  ViewGain gain(map, views, snapshot.features->unobserved, params_.gain);
  std::vector<Viewpoint> weighed = weigh(map, snapshot, gain, min_gain_m2);
  if (!company_.promised.empty()) {
    for (const PromisedLook& promised : company_.promised) {
      const auto outbids = [&](const Viewpoint& mine) {
        return (mine.at_m - promised.at_m).norm() < params_.contest_m &&
               mine.gain_per_s > params_.outbid * promised.utility;
      };
      if (std::none_of(weighed.begin(), weighed.end(), outbids)) {
        gain.leave_to(promised);
      }
    }
    weighed = weigh(map, snapshot, gain, min_gain_m2);
  }
  weighed_ = told_places(weighed);
  return weighed.empty() ? std::nullopt : std::optional(weighed.front());
}

std::vector<Viewpoint> Frontier::weigh(const RasterMap& map,
                                       const pipeline::Snapshot& snapshot,
                                       const ViewGain& gain,
                                       double min_gain_m2) const {
  ViewpointParams viewpoints = params_.viewpoints;
  viewpoints.min_gain_m2 = min_gain_m2;
  const Pose2& T_map_robot = snapshot.latest.T_map_robot;
  std::vector<FrontierCells> frontiers = find_frontiers(map, map.cell_at(T_map_robot.position_m()));
  const CostGridParams& costs = params_.navigator.costs;
  for (const UnobservedWall& unobserved : gain.unobserved()) {
    const CellIndex before =
        map.cell_at(before_m(unobserved, costs.robot_radius_m + costs.clearance_m));
    if (map.contains(before)) {
      frontiers.push_back({before});
    }
  }
  return weigh_viewpoints(
      navigator_.costs(), navigator_.travel(), frontiers, gain, T_map_robot, viewpoints);
}

bool Frontier::has_enough(const pipeline::Snapshot& snapshot) const {
  CoverageParams params;
  params.costs = params_.navigator.costs;
  params.gain = params_.gain;
  return coverage_of(snapshot, params).share() >= params_.enough_share;
}

/// The nearest that was not tried. The floor right behind it is supposed to be there, until
/// something stops the robot.
std::optional<Viewpoint> Frontier::choose_opening(const RasterMap& map,
                                                  const pipeline::Snapshot& snapshot) {
  std::optional<Viewpoint> nearest;
  for (const Opening& opening : find_openings(map, *snapshot.scans, params_.openings)) {
    const auto cost_m = navigator_.travel().cost_m(map.cell_at(opening.edge_m));
    const bool is_free = !was_tried(opening.beyond_m, map) && !is_left_to_others(opening.beyond_m);
    if (cost_m && is_free && (!nearest || *cost_m < nearest->cost_m)) {
      nearest = Viewpoint{opening.beyond_m, kAllRound, *cost_m, 0.0};
    }
  }
  if (!nearest) {
    return std::nullopt;
  }
  navigator_.forget_failures();
  nearest->cost_m += params_.openings.step_m;
  RasterMap stepped = map;
  const double radius_m = params_.openings.step_m + 2.0 * map.resolution_m();
  draw_disc(stepped, nearest->at_m, radius_m, {CellState::kUnknown}, CellState::kFree);
  navigator_.set_hypothetical_map(stepped, snapshot);
  return nearest;
}

/// Where the floor is open only because the robot stands there (CostGridParams::standing_m): a goal
/// there would be chosen again, however often the robot is stopped before it.
bool Frontier::is_beside_goal(const Pose2& T_map_robot) const {
  return goal_ && goal_kind_ != IntentKind::kOpening &&
         (goal_->at_m - T_map_robot.position_m()).norm() <= params_.navigator.costs.standing_m;
}

void Frontier::end_try_of_door() {
  if (door_m_) {
    tried_doors_m_.push_back(*door_m_);
    door_m_.reset();
  }
}

bool Frontier::is_left_to_others(const Eigen::Vector2d& opening_m) const {
  const auto& promised = company_.promised;
  return std::any_of(promised.begin(), promised.end(), [&](const PromisedLook& look) {
    return (look.at_m - opening_m).norm() < params_.contest_m;
  });
}

Frontier::TriedOpening& Frontier::opening_at(const Eigen::Vector2d& opening_m) {
  const auto known = std::ranges::find_if(openings_, [&](const TriedOpening& tried) {
    return (tried.at_m - opening_m).norm() < params_.openings_apart_m;
  });
  return known != openings_.end() ? *known : openings_.emplace_back(TriedOpening{opening_m});
}

/// In vain: where one that was chosen has become floor, the way goes on. One that the robot was
/// stopped on the way to is worth another try.
bool Frontier::was_tried(const Eigen::Vector2d& opening_m, const RasterMap& map) const {
  const auto is_near = [&](const Eigen::Vector2d& place_m) {
    return (place_m - opening_m).norm() < params_.openings_apart_m;
  };
  const auto is_in_vain = [&](const TriedOpening& tried) {
    return is_near(tried.at_m) && (tried.is_reached || tried.bumps >= params_.opening_tries) &&
           map.state(map.cell_at(tried.at_m)) != CellState::kFree;
  };
  return std::ranges::any_of(openings_, is_in_vain) ||
         std::ranges::any_of(navigator_.obstacles_m(), is_near);
}

/// On along the way; where it ends, or has taken too long, the sweep.
Motion Frontier::drive_on(const pipeline::Snapshot& snapshot) {
  if (const auto motion = navigator_.next(snapshot.latest.T_map_robot)) {
    return *motion;
  }
  // NOLINTBEGIN(bugprone-unchecked-optional-access): it drives to a goal
  if (goal_kind_ == IntentKind::kOpening) {
    opening_at(goal_->at_m).is_reached = true;
  }
  end_try_of_door();
  return begin_sweep(snapshot, goal_->view);
  // NOLINTEND(bugprone-unchecked-optional-access)
}

Motion Frontier::begin_sweep(const pipeline::Snapshot& snapshot, const BestView& view) {
  const double heading_rad = snapshot.latest.T_map_robot.heading_rad();
  phase_ = Phase::kSensing;
  return plan_.begin(is_full_turn(view.width_rad)
                         ? stop_sweep(params_.sweep, snapshot.stops, heading_rad > 0.0)
                         : sector_sweep(heading_rad, view));
}

/// The body turns only as far as the pan does not reach.
std::deque<Motion> Frontier::sector_sweep(double heading_rad, const BestView& view) const {
  const double half_rad = std::min(0.5 * view.width_rad, params_.sweep.pan_limit_rad);
  const double slack_rad = params_.sweep.pan_limit_rad - half_rad;
  const double off_rad = geometry::angle_between(heading_rad, view.middle_rad);
  const double pan_rad = std::clamp(off_rad, -slack_rad, slack_rad);
  const double steps = std::max(1.0, std::round(2.0 * half_rad / params_.sweep.step_rad));
  std::deque<Motion> motions{BeginScan{}};
  if (std::abs(off_rad) > slack_rad) {
    motions.emplace_back(
        Turn{unwinding_turn_rad(heading_rad, geometry::wrap_angle(view.middle_rad - pan_rad))});
  }
  motions.emplace_back(Sweep{
      pan_rad - half_rad, pan_rad + half_rad, 2.0 * half_rad / steps, params_.sweep.settle_s});
  motions.emplace_back(EndScan{});
  return motions;
}

}  // namespace echomap::exploration
