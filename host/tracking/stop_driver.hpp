// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <random>
#include <string>

#include "host/exploration/nxt_farthest.hpp"
#include "host/pipeline/robot_pipeline.hpp"
#include "host/session/robot_context.hpp"

namespace echomap::tracking {

/// Drives a robot from stop to stop, sweeps its sonar at each and looks around on the way, as long
/// as is wanted, for others that listen at the same fork. Where to go, the strategy of the
/// exploration decides by a map of its own, which begins where the driver does.
class StopDriver {
 public:
  /// `robot`, which is open, outlives this. The SLAM method of that name (session::pipeline_for)
  /// places the robot in the driver's own map.
  StopDriver(session::RobotContext& robot, std::string slam);
  ~StopDriver();
  StopDriver(const StopDriver&) = delete;
  StopDriver& operator=(const StopDriver&) = delete;

  /// To the end of the next stop's scan; false where the session has ended or the strategy knows
  /// nothing more to do, which `finished` tells. Where there is nowhere to go it listens once more
  /// from the same place, a few times. Of the goals that can be reached it takes the one of the
  /// greatest value.
  bool go_to_next_stop(const exploration::NxtFarthest::GoalValue& value);
  /// The robot was carried off: the driver's map is of somewhere else.
  void restart();

  /// Of the driver's own map.
  const pipeline::RobotPipeline& pipeline() const { return *pipeline_; }
  std::optional<exploration::FinishReason> finished() const { return finished_; }

 private:
  session::RobotContext& robot_;
  std::string slam_;
  std::mt19937 random_;
  std::unique_ptr<pipeline::RobotPipeline> pipeline_;
  std::unique_ptr<exploration::NxtFarthest> explorer_;
  int stops_on_the_spot_ = 0;  ///< Consecutive count.
  exploration::MotionResult last_ = exploration::MotionResult::kReached;
  std::optional<exploration::FinishReason> finished_;
};

}  // namespace echomap::tracking
