// SPDX-License-Identifier: MIT
#include "host/exploration/atlas_explorer.hpp"

#include <utility>
#include <variant>

namespace echomap::exploration {
namespace {

/// A robot that is lost in so many maps in a row, and none of them found again, goes on losing
/// them.
constexpr std::size_t kMaxMapsLost = 4;

}  // namespace

AtlasExplorer::AtlasExplorer(MakeExplorer make, std::size_t stops, bool begins_new_map)
    : make_(std::move(make)), begins_new_map_(begins_new_map) {
  begin_strategy(stops);
}

Motion AtlasExplorer::next(const pipeline::Snapshot& snapshot, MotionResult last) {
  if (const auto otherwise = std::exchange(otherwise_, std::nullopt)) {
    if (last != MotionResult::kReached) {
      return *otherwise;
    }
    maps_lost_ = is_lost_ ? maps_lost_ + 1 : 0;
    begin_strategy(snapshot.stops);
    return next_of_strategy(snapshot, MotionResult::kReached);
  }
  stops_made_ += snapshot.stops - stops_;
  const bool is_new_stop = std::exchange(stops_, snapshot.stops) != snapshot.stops;
  if (!begins_new_map_) {
    return next_of_strategy(snapshot, last);
  }
  if (snapshot.times_lifted > 0 || std::exchange(was_moved_, false)) {
    return ask_for(BeginNewMap{}, Finished{FinishReason::kLifted});
  }
  const Motion motion = next_of_strategy(snapshot, last);
  const auto* finished = std::get_if<Finished>(&motion);
  is_lost_ =
      finished != nullptr && finished->reason == FinishReason::kLost && maps_lost_ < kMaxMapsLost;
  if (is_lost_) {
    return ask_for(BeginNewMap{finished->stops_elsewhere}, motion);
  }
  return is_new_stop ? ask_for(JoinMaps{}, motion) : motion;
}

StrategyProducts AtlasExplorer::products() const {
  return strategy_ ? strategy_->products() : StrategyProducts{};
}

Intent AtlasExplorer::intent() const { return strategy_ ? strategy_->intent() : Intent{}; }

void AtlasExplorer::begin_strategy(std::size_t stops) {
  strategy_ = make_(stops_made_);
  stops_ = stops;
  stops_before_ = stops;
}

Motion AtlasExplorer::ask_for(const Motion& change, const Motion& otherwise) {
  otherwise_ = otherwise;
  return change;
}

Motion AtlasExplorer::next_of_strategy(pipeline::Snapshot snapshot, MotionResult last) {
  if (!strategy_) {
    return Finished{FinishReason::kStopLimit};
  }
  snapshot.stops -= stops_before_;
  return strategy_->next(snapshot, last);
}

std::optional<MotionResult> change_maps(pipeline::RobotAtlas& atlas, const Motion& motion) {
  if (const auto* begin = std::get_if<BeginNewMap>(&motion)) {
    atlas.begin_new_map(begin->stops_elsewhere);
    return MotionResult::kReached;
  }
  if (std::holds_alternative<JoinMaps>(motion)) {
    return atlas.join() ? MotionResult::kReached : MotionResult::kRefused;
  }
  return std::nullopt;
}

}  // namespace echomap::exploration
