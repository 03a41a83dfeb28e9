// SPDX-License-Identifier: MIT
#include "host/time/sender_clock.hpp"

#include <chrono>
#include <cmath>

namespace echomap::time {
namespace {

constexpr std::chrono::seconds kWindow(60);
/// What is farther off is of another clock; no message is under way for so long.
constexpr double kMaxOffS = 1.0;
/// So many in a row that agree are of one clock. A jam that lets go all at once looks different:
/// there each message is less late than the one before by a picture's period.
constexpr int kMaxOthers = 3;
constexpr double kAgreesS = 0.05;

double seconds_of(HostTime at) {
  return std::chrono::duration<double>(at.time_since_epoch()).count();
}

}  // namespace

bool SenderClock::add(double sent_s, HostTime arrived) {
  const double apart_s = seconds_of(arrived) - sent_s;
  if (!offsets_.empty() && std::abs(apart_s - offsets_.front().apart_s) > kMaxOffS) {
    if (!is_another_clock(apart_s)) {
      return false;
    }
    offsets_.clear();
  }
  others_ = 0;
  while (!offsets_.empty() && offsets_.back().apart_s >= apart_s) {
    offsets_.pop_back();
  }
  offsets_.push_back({arrived, apart_s});
  while (offsets_.front().arrived + kWindow < arrived) {
    offsets_.pop_front();
  }
  return true;
}

bool SenderClock::is_another_clock(double apart_s) {
  if (others_ == 0 || std::abs(apart_s - other_apart_s_) > kAgreesS) {
    other_apart_s_ = apart_s;
    others_ = 0;
  }
  return ++others_ >= kMaxOthers;
}

std::optional<HostTime> SenderClock::host_time(double sender_s) const {
  if (offsets_.empty()) {
    return std::nullopt;
  }
  const double host_s = sender_s + offsets_.front().apart_s;
  return HostTime(HostClock::duration(std::llround(host_s * 1e6)));
}

}  // namespace echomap::time
