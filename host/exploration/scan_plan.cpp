// SPDX-License-Identifier: MIT
#include "host/exploration/scan_plan.hpp"

#include <utility>
#include <variant>

namespace echomap::exploration {

Motion ScanPlan::begin(std::deque<Motion> motions) {
  motions_ = std::move(motions);
  has_swept_ = false;
  return take();
}

void ScanPlan::end_motion(MotionResult result) {
  has_swept_ = has_swept_ || (is_sweeping_ && result == MotionResult::kReached);
  is_sweeping_ = false;
}

std::optional<Motion> ScanPlan::next() {
  return motions_.empty() ? std::nullopt : std::optional(take());
}

Motion ScanPlan::take() {
  Motion motion = motions_.front();
  motions_.pop_front();
  is_sweeping_ = std::holds_alternative<Sweep>(motion);
  return motion;
}

}  // namespace echomap::exploration
