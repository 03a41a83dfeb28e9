// SPDX-License-Identifier: MIT
#include "host/exploration/fault_watch.hpp"

#include <algorithm>
#include <utility>

#include "host/geometry/parameter_validator.hpp"

namespace echomap::exploration {
namespace {

bool has_stalled(MotionResult result) {
  return result == MotionResult::kStalled || result == MotionResult::kTimedOut;
}

/// Without a map no echo is known.
mapping::ScanFit fit_in(const std::shared_ptr<const mapping::OccupancyGrid>& map,
                        const mapping::Scan& scan) {
  return map ? mapping::fit_of(scan, *map) : mapping::ScanFit{};
}

/// Where a strategy ends by what its map shows.
bool trusts_its_map(FinishReason reason) {
  return reason == FinishReason::kComplete || reason == FinishReason::kNoNewGround ||
         reason == FinishReason::kNowhereToGo;
}

}  // namespace

FaultWatch::FaultWatch(std::unique_ptr<Explorer> strategy, const FaultWatchParams& params)
    : strategy_(std::move(strategy)), params_(params) {
  geometry::ParameterValidator("fault watch")
      .require(strategy_ != nullptr, "a strategy must be given")
      .positive("scans_elsewhere", params.scans_elsewhere)
      .positive("silent_readings", params.silent_readings)
      .at_least("compared_scans", params.compared_scans, params.min_compared_scans)
      .positive("compared_echoes", params.compared_echoes)
      .positive("max_floor_share", params.max_floor_share)
      .positive("doubtful_echoes", params.doubtful_echoes)
      .positive("doubtful_floor_share", params.doubtful_floor_share)
      .positive("max_stalled_turns", params.max_stalled_turns)
      .positive("try_turn_rad", params.try_turn_rad);
}

Motion FaultWatch::next(const pipeline::Snapshot& snapshot, MotionResult last) {
  const auto fault = fault_of_scans(snapshot);
  map_before_ = snapshot.grid;
  scans_before_ = snapshot.scans;
  if (fault) {
    return *fault;
  }
  if (turns_ > 0 || has_stalled(last)) {
    if (const auto motion = try_wheels(last)) {
      return *motion;
    }
    last = stalled_;
  }
  const Motion motion = strategy_->next(snapshot, last);
  const auto* end = std::get_if<Finished>(&motion);
  return end && trusts_its_map(end->reason) && nearly_lost() ? lost() : motion;
}

std::optional<Finished> FaultWatch::fault_of_scans(const pipeline::Snapshot& snapshot) {
  if (std::exchange(stops_, snapshot.stops) == snapshot.stops) {
    return std::nullopt;
  }
  const mapping::Scan& scan = *snapshot.last_scan;
  for (const mapping::PlacedReading& reading : scan) {
    silent_readings_ = reading.has_answered ? 0 : silent_readings_ + 1;
  }
  if (silent_readings_ >= params_.silent_readings) {
    return Finished{FinishReason::kSonarSilent};
  }
  if (snapshot.last_scan_fault == mapping::ScanFault::kStuck) {
    return Finished{FinishReason::kSonarStuck};
  }
  const bool is_in_map = snapshot.last_scan_fault == mapping::ScanFault::kNone;
  const auto before =
      map_before_ ? mapping::compared_map(map_before_, *scans_before_) : map_before_;
  fits_.push_back({fit_in(before, scan), fit_in(is_in_map ? snapshot.grid : nullptr, scan)});
  if (fits_.size() > params_.compared_scans) {
    fits_.pop_front();
  }
  const bool is_elsewhere = snapshot.last_scan_fault == mapping::ScanFault::kElsewhere ||
                            is_doubtful(fits_.back().before);
  scans_elsewhere_ = is_elsewhere ? scans_elsewhere_ + 1 : 0;
  const bool is_lost = map_contradicts_itself() || scans_elsewhere_ >= params_.scans_elsewhere;
  return is_lost ? std::optional(lost()) : std::nullopt;
}

bool FaultWatch::nearly_lost() const {
  return scans_elsewhere_ > 0 && scans_elsewhere_ + 1 >= params_.scans_elsewhere;
}

Finished FaultWatch::lost() const { return {FinishReason::kLost, scans_since_misfit()}; }

std::size_t FaultWatch::scans_since_misfit() const {
  const auto fits = std::find_if(fits_.rbegin(), fits_.rend(), [&](const Fits& fit) {
    const auto known = static_cast<double>(fit.before.on_walls + fit.before.on_floor);
    return static_cast<double>(fit.before.on_floor) <= params_.mixed_floor_share * known;
  });
  return std::max(scans_elsewhere_, static_cast<std::size_t>(fits - fits_.rbegin()));
}

bool FaultWatch::is_doubtful(const mapping::ScanFit& fit) const {
  const std::size_t known = fit.on_walls + fit.on_floor;
  return known >= params_.doubtful_echoes &&
         static_cast<double>(fit.on_floor) >=
             params_.doubtful_floor_share * static_cast<double>(known);
}

bool FaultWatch::map_contradicts_itself() const {
  std::size_t known = 0;
  std::size_t on_floor = 0;
  for (const Fits& fit : fits_) {
    known += fit.after.on_walls + fit.after.on_floor;
    on_floor += fit.after.on_floor;
  }
  return fits_.size() >= params_.min_compared_scans && known >= params_.compared_echoes &&
         static_cast<double>(on_floor) >= params_.max_floor_share * static_cast<double>(known);
}

/// To and fro until a turn does not stall; the robot is left turned by that one.
std::optional<Motion> FaultWatch::try_wheels(MotionResult last) {
  if (turns_ == 0) {
    stalled_ = last;
  } else if (!has_stalled(last)) {
    turns_ = 0;
    return std::nullopt;
  } else if (turns_ == params_.max_stalled_turns) {
    return Finished{FinishReason::kWheelFault};
  }
  const double sign = turns_ % 2 == 0 ? 1.0 : -1.0;
  ++turns_;
  return Turn{sign * params_.try_turn_rad};
}

}  // namespace echomap::exploration
