// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "host/pipeline/robot_atlas.hpp"
#include "host/session/robot_context.hpp"
#include "host/tracking/localization_drive.hpp"

namespace echomap::tracking {

/// Lets a strategy drive a robot that is localized: one without a sonar, which feels its way, or
/// one that shall drive as a paper has it. A stretch ends with a scan, or after so much way that
/// there is something new to tell.
class StrategyDrive final : public LocalizationDrive {
 public:
  using MakeExplorer = std::function<std::unique_ptr<exploration::Explorer>()>;

  /// `robot`, which is open, outlives this. `make` is called at the start and for each new map.
  StrategyDrive(session::RobotContext& robot, MakeExplorer make);
  ~StrategyDrive() override;

  bool go_to_next_stop() override;
  void begin_new_map(std::size_t stops_elsewhere) override;
  std::optional<exploration::FinishReason> finished() const override { return finished_; }
  exploration::Intent intent() const override { return explorer_->intent(); }

 private:
  session::RobotContext& robot_;
  MakeExplorer make_;
  pipeline::RobotAtlas atlas_;
  std::unique_ptr<exploration::Explorer> explorer_;
  exploration::MotionResult last_ = exploration::MotionResult::kReached;
  std::optional<exploration::FinishReason> finished_;
};

}  // namespace echomap::tracking
