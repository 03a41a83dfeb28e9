// SPDX-License-Identifier: MIT
#include "host/time/sender_clock.hpp"

#include <chrono>
#include <cmath>

namespace echomap::time {
namespace {

constexpr std::chrono::seconds kWindow(60);

double seconds_of(HostTime at) {
  return std::chrono::duration<double>(at.time_since_epoch()).count();
}

}  // namespace

void SenderClock::add(double sent_s, HostTime arrived) {
  const double apart_s = seconds_of(arrived) - sent_s;
  while (!offsets_.empty() && offsets_.back().apart_s >= apart_s) {
    offsets_.pop_back();
  }
  offsets_.push_back({arrived, apart_s});
  while (offsets_.front().arrived + kWindow < arrived) {
    offsets_.pop_front();
  }
}

std::optional<HostTime> SenderClock::host_time(double sender_s) const {
  if (offsets_.empty()) {
    return std::nullopt;
  }
  const double host_s = sender_s + offsets_.front().apart_s;
  return HostTime(HostClock::duration(std::llround(host_s * 1e6)));
}

}  // namespace echomap::time
