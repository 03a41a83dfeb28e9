// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "protocol/telemetry_messages.hpp"

namespace echomap {
namespace control {

/// How the last move or sweep stands. `id` is its command's; 0 for set-points, which only report
/// that they were cut short.
struct MotionReport {
  uint8_t id;
  protocol::MotionOutcome outcome;
};

inline bool operator!=(const MotionReport& a, const MotionReport& b) {
  return a.id != b.id || a.outcome != b.outcome;
}

}  // namespace control
}  // namespace echomap
