// SPDX-License-Identifier: MIT
#include "host/fleet_member/team_searcher.hpp"

#include <utility>
#include <variant>

#include "host/exploration/company.hpp"
#include "host/geometry/parameter_validator.hpp"
#include "host/team_exploration/claims.hpp"
#include "host/time/robot_seconds.hpp"

namespace echomap::fleet_member {

using exploration::Finished;
using exploration::FinishReason;
using exploration::Motion;
using exploration::MotionResult;
using pipeline::Snapshot;
using source_search::FieldReading;
using source_search::SourceVerdict;

namespace {

constexpr const char* kOwnReadings = "";

/// What all have seen in place of the robot's own, with a stop for each scan of theirs.
Snapshot known_to_all(const Snapshot& snapshot, const exploration::Company& company) {
  Snapshot known = exploration::with_company(snapshot, company);
  known.stops = company.scans ? company.scans->size() : snapshot.stops;
  return known;
}

}  // namespace

TeamSearcher::TeamSearcher(SearchBoard& board,
                           std::shared_ptr<source_search::SourceSearch> search,
                           const source_search::SourceReadings& readings,
                           const TeamSearcherParams& params)
    : params_(params),
      avoidance_(params.avoidance),
      board_(board),
      search_(std::move(search)),
      own_(readings) {
  geometry::ParameterValidator("team searcher")
      .positive("max_silent_s", params.max_silent_s)
      .positive("max_s", params.max_s);
}

Motion TeamSearcher::next(const Snapshot& snapshot, MotionResult last) {
  if (own_.elapsed_s() > params_.max_s) {
    return Finished{FinishReason::kStopLimit};
  }
  const auto view = team_exploration::without_silent(board_.view(), params_.max_silent_s);
  const Motion motion = decide(snapshot, view, last);
  publish();
  return motion;
}

Motion TeamSearcher::decide(const Snapshot& snapshot,
                            const team_exploration::TeamView& view,
                            MotionResult last) {
  const SearchView others = board_.search_view();
  if (others.finding) {
    return Finished{FinishReason::kComplete};
  }
  const bool is_driving = search_->is_driving() || avoidance_.is_making_way();
  const bool has_run_into_peer = avoidance_.has_run_into_peer(snapshot, view, last);
  if (is_driving && has_run_into_peer) {
    return avoidance_.back_off(snapshot);
  }
  if (auto motion = avoidance_.next(snapshot, view, last)) {
    return *motion;
  }
  if (avoidance_.wants_another_goal()) {
    search_->reconsider();
  }
  const double now_s = time::robot_seconds(snapshot.latest.stamp);
  const exploration::Company company = avoidance_.company(view, now_s);
  search_->set_company(company);
  search_->set_plans_of_others(others.plans);
  search_->set_readings(all_readings(snapshot, others));
  const Motion motion = search_->next(known_to_all(snapshot, company), last);
  const bool may_change = avoidance_.plans_around_bump(now_s) && !search_->has_ended();
  if (may_change && std::holds_alternative<Finished>(motion)) {
    return exploration::Stand{params_.avoidance.look_again_s};
  }
  return avoidance_.checked(snapshot, view, motion);
}

/// Returns all readings in the order in which they came: those behind the known ones are new. Where
/// a robot has fewer than before, as one that has begun another map, the order starts again.
std::vector<FieldReading> TeamSearcher::all_readings(const Snapshot& snapshot,
                                                     const SearchView& others) {
  std::map<std::string, std::vector<FieldReading>> by_map;
  by_map[kOwnReadings] = own_.placed(snapshot);
  for (const SharedReading& shared : others.readings) {
    by_map[shared.map].push_back(shared.reading);
  }
  for (const auto& [map, taken] : taken_) {
    if (by_map[map].size() < taken) {
      order_.clear();
    }
  }
  if (order_.empty()) {
    taken_.clear();
  }
  for (const auto& [map, readings] : by_map) {
    std::size_t& taken = taken_[map];
    order_.insert(order_.end(), readings.size() - taken, map);
    taken = readings.size();
  }
  std::vector<FieldReading> all;
  std::map<std::string, std::size_t> next;
  for (const std::string& map : order_) {
    all.push_back(by_map[map][next[map]++]);
  }
  return all;
}

/// Publishes the result so far, the plan and the claim, where they have changed.
void TeamSearcher::publish() {
  fleet_messages::SearchReport report;
  if (const auto* belief = search_->belief()) {
    const source_search::SourceEstimate& estimate = belief->estimate();
    if (search_->has_ended()) {
      report.verdict = estimate.verdict;
    }
    if (report.verdict == SourceVerdict::kFound) {
      report.at_m = estimate.best_m;
      report.strength = estimate.strength.median;
      report.probability = estimate.within_probability;
    } else if (report.verdict == SourceVerdict::kNone) {
      report.probability = estimate.none_probability;
    }
  }
  report.plan = search_->plan();
  board_.publish_search(report);
  claim();
}

/// Claims the goal and names the robot in its way. It bids for no floor.
void TeamSearcher::claim() {
  std::optional<team_exploration::Claim> claim;
  const auto goal = search_->intent().goal;
  if (goal && !search_->has_ended()) {
    claim = {params_.avoidance.robot, goal->at_m, 0.0, 0.0, avoidance_.waits_for()};
  }
  const bool is_same =
      claim.has_value() == claim_.has_value() &&
      (!claim || (claim->at_m == claim_->at_m && claim->waits_for == claim_->waits_for));
  if (!is_same) {
    claim_ = claim;
    board_.claim(claim);
  }
}

}  // namespace echomap::fleet_member
