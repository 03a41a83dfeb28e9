// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>

namespace echomap::fleet {

/// A token bucket (RFC 2697 has the idea): bytes per second in the mean, and some more at once.
class ByteBudget {
 public:
  /// Both are positive.
  ByteBudget(double bytes_per_s, double burst_bytes)
      : bytes_per_s_(bytes_per_s), burst_bytes_(burst_bytes), left_bytes_(burst_bytes) {}

  /// Fills up to that time, in seconds of any clock that does not go back.
  void advance_to(double now_s) {
    left_bytes_ = std::min(burst_bytes_, left_bytes_ + bytes_per_s_ * std::max(0.0, now_s - at_s_));
    at_s_ = std::max(at_s_, now_s);
  }
  /// Whether something may be spent. What is then spent may be more than there is: it is missing
  /// afterwards, so that the mean holds and a large message is not held back for ever.
  bool has_some() const { return left_bytes_ > 0.0; }
  void spend(std::size_t bytes) { left_bytes_ -= static_cast<double>(bytes); }

 private:
  double bytes_per_s_;
  double burst_bytes_;
  double left_bytes_;
  double at_s_ = 0.0;
};

}  // namespace echomap::fleet
