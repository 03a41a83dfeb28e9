// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "host/apps/explore_progress.hpp"
#include "host/apps/explore_run.hpp"
#include "host/apps/live_source.hpp"
#include "host/exploration/atlas_explorer.hpp"
#include "host/session/robot_context.hpp"

namespace echomap::apps {

/// Of a normal distribution, 95 % lie within so many standard deviations.
inline constexpr double kStddevsOf95 = 1.96;

/// What a motion is called while the robot carries it out: "drives 0.80 m".
std::string words_of(const exploration::Motion& motion);

/// What the terminal shows of a link to a robot.
terminal_view::LinkHealth health_of(const robot_link::LinkStatistics& statistics);

/// Shows an exploration: where it has come to, and what its explorer asks for, which it passes on.
class ExploreView final : public ProgressSource, public exploration::Explorer {
 public:
  /// All of them outlive this; the exploration begins.
  ExploreView(const session::RobotContext& robot,
              const ExploreRun& run,
              exploration::AtlasExplorer& explorer);

  exploration::Motion next(const pipeline::Snapshot& snapshot,
                           exploration::MotionResult last) override;
  exploration::StrategyProducts products() const override { return explorer_.products(); }

  /// What it is about.
  exploration::Intent intent() const override { return explorer_.intent(); }
  LiveProgress live_progress() const;

  std::string line() override;
  terminal_view::RunView view() override;
  /// Robot's time, that of a run which this one resumes included.
  double elapsed_s() const override;

 private:
  ExploreProgress progress(const pipeline::Snapshot& snapshot) const;
  /// After a stop, while the robot stands: on a large map it takes longer than a robot drives by
  /// itself.
  void look_at_stop(const pipeline::Snapshot& snapshot);
  void describe_robot(const pipeline::Snapshot& snapshot, terminal_view::RunStatus& status) const;

  const session::RobotContext& robot_;
  const ExploreRun& run_;
  exploration::AtlasExplorer& explorer_;
  std::size_t stops_before_;
  std::string doing_ = "connects";
  std::optional<exploration::Coverage> coverage_;  ///< As of the last stop.
  std::size_t covered_stops_ = 0;                  ///< Of the map then.
};

}  // namespace echomap::apps
