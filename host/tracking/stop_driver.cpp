// SPDX-License-Identifier: MIT
#include "host/tracking/stop_driver.hpp"

#include <limits>
#include <optional>
#include <utility>
#include <variant>

#include "host/session/pipeline_setup.hpp"
#include "host/strategies/strategy_setup.hpp"

namespace echomap::tracking {
namespace {

using exploration::FinishReason;

constexpr int kMaxStopsOnTheSpot = 3;

/// The strategy, without an end of its own: its ground need not be new.
exploration::NxtFarthestParams endless(const session::RobotProfile& profile) {
  constexpr auto kNever = std::numeric_limits<std::size_t>::max();
  auto params = strategies::nxt_farthest_params(profile, std::nullopt);
  params.stops_without_new_ground = kNever;
  return params;
}

}  // namespace

StopDriver::StopDriver(session::RobotContext& robot, std::string slam)
    : robot_(robot),
      slam_(std::move(slam)),
      random_(robot.seed().generator(session::SeedPurpose::kStopDriver)) {
  robot_.session().look_around_on_the_way(true);
  restart();
}

StopDriver::~StopDriver() {
  robot_.session().look_around_on_the_way(false);
  robot_.fork().remove(*pipeline_);
}

void StopDriver::restart() {
  if (pipeline_) {
    robot_.fork().remove(*pipeline_);
  }
  pipeline_ =
      std::make_unique<pipeline::RobotPipeline>(session::pipeline_for(robot_.profile(), slam_));
  robot_.fork().add(*pipeline_);
  explorer_ = std::make_unique<exploration::NxtFarthest>(endless(robot_.profile()), random_);
  last_ = exploration::MotionResult::kReached;
}

bool StopDriver::go_to_next_stop(const exploration::NxtFarthest::GoalValue& value) {
  while (!robot_.session().end()) {
    explorer_->prefer(value);
    const auto motion = explorer_->next(pipeline_->snapshot(), last_);
    if (const auto* finished = std::get_if<exploration::Finished>(&motion)) {
      if (finished->reason != FinishReason::kNowhereToGo ||
          ++stops_on_the_spot_ == kMaxStopsOnTheSpot) {
        finished_ = finished->reason;
        return false;
      }
      restart();  // What bars the way may be its own map's fault.
      continue;
    }
    stops_on_the_spot_ =
        std::holds_alternative<exploration::Drive>(motion) ? 0 : stops_on_the_spot_;
    last_ = robot_.move(motion);
    if (std::holds_alternative<exploration::EndScan>(motion)) {
      return !robot_.session().end();
    }
  }
  return false;
}

}  // namespace echomap::tracking
