// SPDX-License-Identifier: MIT
#include "host/exploration/atlas_explorer.hpp"

#include <utility>
#include <variant>

namespace echomap::exploration {

AtlasExplorer::AtlasExplorer(pipeline::RobotAtlas& atlas, MakeExplorer make, bool begins_anew)
    : atlas_(atlas), make_(std::move(make)), begins_anew_(begins_anew) {
  begin_strategy();
}

Motion AtlasExplorer::next(const pipeline::Snapshot& snapshot, MotionResult last) {
  stops_made_ += snapshot.stops - stops_;
  const bool is_new_stop = std::exchange(stops_, snapshot.stops) != snapshot.stops;
  if (!begins_anew_) {
    return next_of_strategy(snapshot, last);
  }
  if (snapshot.times_lifted > 0) {
    atlas_.begin_anew(0);
    return go_on();
  }
  const Motion motion = next_of_strategy(snapshot, last);
  const auto* finished = std::get_if<Finished>(&motion);
  if (finished != nullptr && finished->reason == FinishReason::kLost) {
    atlas_.begin_anew(finished->stops_elsewhere);
    return go_on();
  }
  return is_new_stop && atlas_.join() ? go_on() : motion;
}

StrategyProducts AtlasExplorer::products() const {
  return strategy_ ? strategy_->products() : StrategyProducts{};
}

void AtlasExplorer::begin_strategy() {
  strategy_ = make_(stops_made_);
  const auto snapshot = atlas_.pipeline().snapshot();
  stops_ = snapshot.stops;
  stops_before_ = snapshot.stops;
}

Motion AtlasExplorer::go_on() {
  begin_strategy();
  return next_of_strategy(atlas_.pipeline().snapshot(), MotionResult::kReached);
}

Motion AtlasExplorer::next_of_strategy(pipeline::Snapshot snapshot, MotionResult last) {
  if (!strategy_) {
    return Finished{FinishReason::kStopLimit};
  }
  snapshot.stops -= stops_before_;
  return strategy_->next(snapshot, last);
}

}  // namespace echomap::exploration
