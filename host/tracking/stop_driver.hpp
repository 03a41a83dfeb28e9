// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>

#include "host/exploration/active_localization.hpp"
#include "host/exploration/fault_watch.hpp"
#include "host/pipeline/robot_atlas.hpp"
#include "host/session/robot_context.hpp"
#include "host/tracking/localization_drive.hpp"

namespace echomap::tracking {

/// Drives a robot from stop to stop, sweeps its sonar at each and looks around on the way, as long
/// as is wanted, for others that listen at the same fork. Where to go,
/// exploration::ActiveLocalization decides by a map of its own, which begins where the driver does.
class StopDriver final : public LocalizationDrive {
 public:
  /// `robot`, which is open, outlives this. The SLAM method of that name (session::pipeline_for)
  /// places the robot in the driver's own map.
  StopDriver(session::RobotContext& robot,
             const std::string& slam,
             exploration::ActiveLocalization::GoalUtility utility);
  ~StopDriver() override;

  /// To the end of the next stop's scan; false where the session has ended, a part of the robot is
  /// broken or there is nowhere to go, which `finished` tells. Its own map may be wrong: where what
  /// it hears contradicts the map it begins a new one, and so it does, once on a spot, where no way
  /// leads anywhere.
  bool go_to_next_stop() override;
  void begin_new_map(std::size_t stops_elsewhere) override;

  /// Of the driver's own map.
  const pipeline::RobotPipeline& pipeline() const { return atlas_.pipeline(); }
  std::optional<exploration::FinishReason> finished() const override { return finished_; }
  exploration::Intent intent() const override { return explorer_->intent(); }

 private:
  void begin();

  session::RobotContext& robot_;
  pipeline::RobotAtlas atlas_;
  exploration::ActiveLocalization::GoalUtility utility_;
  std::unique_ptr<exploration::FaultWatch> explorer_;
  bool began_on_the_spot_ = false;  ///< A new map, since the old one had no way.
  exploration::MotionResult last_ = exploration::MotionResult::kReached;
  std::optional<exploration::FinishReason> finished_;
};

}  // namespace echomap::tracking
