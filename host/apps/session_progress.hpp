// SPDX-License-Identifier: MIT
#pragma once

#include <cstdio>
#include <optional>

#include "host/apps/explore_progress.hpp"
#include "host/session/robot_context.hpp"

namespace echomap::apps {

/// Shows a run on stderr while the steps of its session pass, until it is finished or gone.
class SessionProgress {
 public:
  /// `source` outlives this.
  SessionProgress(session::RobotContext& robot, ProgressSource& source, ProgressDisplay display)
      : source_(source), reporter_(stderr, display) {
    listener_.emplace(robot, [this] {
      constexpr int kStepsPerDrawing = 64;
      if (++steps_ % kStepsPerDrawing == 0) {
        reporter_.report(source_);
      }
    });
  }

  /// Shows the end, and listens no more.
  void finish() {
    listener_.reset();
    reporter_.finish(source_);
  }

 private:
  ProgressSource& source_;
  ProgressReporter reporter_;
  std::optional<session::RobotContext::StepListener> listener_;
  int steps_ = 0;
};

}  // namespace echomap::apps
