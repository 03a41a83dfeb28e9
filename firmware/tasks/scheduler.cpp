// SPDX-License-Identifier: MIT
#include "firmware/tasks/scheduler.hpp"

namespace echomap {
namespace tasks {

bool Scheduler::take_tick() {
  if (!has_tick()) {
    return false;
  }
  ++served_;
  return true;
}

}  // namespace tasks
}  // namespace echomap
