// SPDX-License-Identifier: MIT
#include "host/live_page/driver_lock.hpp"

namespace echomap::live_page {

DriverLock::Steering DriverLock::steer(std::uint64_t client, bool is_at_rest, double now_ms) {
  if (is_held_by_other(client, now_ms)) {
    return Steering::kHeldByOther;
  }
  if (!holder(now_ms) || is_at_rest) {
    must_let_go_ = false;
  }
  holder_ = client;
  last_steered_ms_ = now_ms;
  return must_let_go_ ? Steering::kMustLetGo : Steering::kAllowed;
}

void DriverLock::stop() { must_let_go_ = true; }

bool DriverLock::release(std::uint64_t client, double now_ms) {
  if (holder(now_ms) != client) {
    return false;
  }
  holder_.reset();
  must_let_go_ = false;
  return true;
}

std::optional<std::uint64_t> DriverLock::holder(double now_ms) const {
  return now_ms - last_steered_ms_ < kSilenceMs ? holder_ : std::nullopt;
}

bool DriverLock::is_held_by_other(std::uint64_t client, double now_ms) const {
  const auto held_by = holder(now_ms);
  return held_by && *held_by != client;
}

}  // namespace echomap::live_page
