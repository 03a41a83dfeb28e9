// SPDX-License-Identifier: MIT
#pragma once

#include <mutex>
#include <vector>

#include "host/session/operator_command.hpp"

namespace echomap::session {

/// The one way by which a person's commands come to a session: other threads push, the session
/// takes them after every step of its time.
class OperatorQueue {
 public:
  /// Replaces one of its kind that waits; a stop lets go of all motion that waits.
  void push(const OperatorCommand& command);
  /// All that wait, in their order.
  std::vector<OperatorCommand> take();

 private:
  std::mutex mutex_;
  std::vector<OperatorCommand> waiting_;
};

}  // namespace echomap::session
