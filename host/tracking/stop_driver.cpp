// SPDX-License-Identifier: MIT
#include "host/tracking/stop_driver.hpp"

#include <memory>
#include <optional>
#include <utility>
#include <variant>

#include "host/session/pipeline_setup.hpp"
#include "host/strategies/strategy_setup.hpp"

namespace echomap::tracking {
StopDriver::StopDriver(session::RobotContext& robot,
                       const std::string& slam,
                       exploration::ActiveLocalization::GoalUtility utility)
    : robot_(robot),
      atlas_(session::atlas_for(robot.profile(), slam, only_map())),
      utility_(std::move(utility)) {
  robot_.session().look_around_on_the_way(true);
  robot_.fork().add(atlas_);
  begin();
}

StopDriver::~StopDriver() {
  robot_.session().look_around_on_the_way(false);
  robot_.fork().remove(atlas_);
}

void StopDriver::begin() {
  explorer_ =
      std::make_unique<exploration::FaultWatch>(std::make_unique<exploration::ActiveLocalization>(
          strategies::active_localization_params(robot_.profile()), utility_));
  last_ = exploration::MotionResult::kReached;
}

void StopDriver::begin_new_map(std::size_t stops_elsewhere) {
  robot_.recorder().add_event(
      {recording::SessionEventKind::kBeginNewMap, static_cast<std::int64_t>(stops_elsewhere), {}});
  atlas_.begin_new_map(stops_elsewhere);
  begin();
}

bool StopDriver::go_to_next_stop() {
  while (!robot_.session().end()) {
    if (pipeline().snapshot().times_lifted > 0) {
      begin_new_map(0);
    }
    const auto motion = explorer_->next(pipeline().snapshot(), last_);
    if (const auto* finished = std::get_if<exploration::Finished>(&motion)) {
      const bool may_be_the_map = finished->reason == exploration::FinishReason::kNowhereToGo &&
                                  !std::exchange(began_on_the_spot_, true);
      if (finished->reason != exploration::FinishReason::kLost && !may_be_the_map) {
        finished_ = finished->reason;
        return false;
      }
      begin_new_map(finished->stops_elsewhere);
      continue;
    }
    last_ = robot_.move(motion);
    if (std::holds_alternative<exploration::EndScan>(motion)) {
      began_on_the_spot_ = began_on_the_spot_ && pipeline().snapshot().stops < 2;
      return !robot_.session().end();
    }
  }
  return false;
}

}  // namespace echomap::tracking
