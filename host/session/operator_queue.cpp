// SPDX-License-Identifier: MIT
#include "host/session/operator_queue.hpp"

#include <utility>
#include <variant>

namespace echomap::session {

void OperatorQueue::push(const OperatorCommand& command) {
  const std::lock_guard lock(mutex_);
  const bool stops = std::holds_alternative<StopRobot>(command);
  std::erase_if(waiting_, [&](const OperatorCommand& waiting) {
    return waiting.index() == command.index() ||
           (stops &&
            (std::holds_alternative<SteerRobot>(waiting) || std::holds_alternative<GoTo>(waiting) ||
             std::holds_alternative<ResumeStrategy>(waiting)));
  });
  waiting_.push_back(command);
}

std::vector<OperatorCommand> OperatorQueue::take() {
  const std::lock_guard lock(mutex_);
  return std::exchange(waiting_, {});
}

}  // namespace echomap::session
