// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <utility>

#include "host/session/robot_context.hpp"

namespace echomap::apps {

/// Calls a function after every step of a robot's session, for as long as it exists.
class StepListener {
 public:
  StepListener(session::RobotContext& robot, std::function<void()> on_step) : robot_(robot) {
    robot_.on_step = std::move(on_step);
  }
  ~StepListener() { robot_.on_step = nullptr; }
  StepListener(const StepListener&) = delete;
  StepListener& operator=(const StepListener&) = delete;

 private:
  session::RobotContext& robot_;
};

}  // namespace echomap::apps
