// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstdint>

namespace echomap::runner {

/// Tells how far simulated time may have gone by a given moment of the machine's clock.
class Pacer {
 public:
  using Moment = std::chrono::steady_clock::time_point;

  /// `speed` simulated seconds in one second of the clock; infinite for no pacing. Throws
  /// std::invalid_argument where it is not positive.
  Pacer(double speed, Moment begin);

  /// Simulated time that is due at `now`, given that `reached_ns` is reached. A machine that has
  /// fallen far behind is forgiven: the pace goes on from where it is.
  std::int64_t due_ns(Moment now, std::int64_t reached_ns);

 private:
  double speed_;
  Moment begin_;
  std::int64_t begin_ns_ = 0;
};

}  // namespace echomap::runner
