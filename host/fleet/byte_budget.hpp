// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>

namespace echomap::fleet {

/// Token bucket that limits traffic to a mean rate in bytes per second and allows bursts (after RFC
/// 2697).
class ByteBudget {
 public:
  /// Both the mean rate and the size of a burst must be positive.
  ByteBudget(double bytes_per_s, double burst_bytes)
      : bytes_per_s_(bytes_per_s), burst_bytes_(burst_bytes), left_bytes_(burst_bytes) {}

  /// Refills the bucket up to `now_s`, in seconds of any clock that never runs backwards.
  void advance_to(double now_s) {
    left_bytes_ = std::min(burst_bytes_, left_bytes_ + bytes_per_s_ * std::max(0.0, now_s - at_s_));
    at_s_ = std::max(at_s_, now_s);
  }
  /// Whether anything may be sent. One message may overdraw the bucket; the deficit then delays
  /// later ones, so that the mean rate holds and a large message is not held back for ever.
  bool has_some() const { return left_bytes_ > 0.0; }
  void spend(std::size_t bytes) { left_bytes_ -= static_cast<double>(bytes); }

 private:
  double bytes_per_s_;
  double burst_bytes_;
  double left_bytes_;
  double at_s_ = 0.0;
};

}  // namespace echomap::fleet
