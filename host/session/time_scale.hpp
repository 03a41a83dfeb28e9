// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <memory>

#include "host/session/pace.hpp"

namespace echomap::session {

/// How fast simulated time may pass beside the time on the wall.
class TimeScale {
 public:
  /// So many times as fast as real time; 0: as fast as it can.
  explicit TimeScale(double factor = 0.0) : factor_(factor) {}

  void set_factor(double factor) { factor_ = factor; }
  double factor() const { return factor_; }
  /// Real time as long as this is on, as where a person steers.
  void keep_real_time(bool on) { is_real_time_ = on; }
  /// The factor that counts now.
  double now() const { return is_real_time_ ? 1.0 : factor_; }

 private:
  double factor_;
  bool is_real_time_ = false;
};

/// A pace that waits where its simulated time would run ahead of the scale. What was late is not
/// made up for. `scale` outlives it.
std::unique_ptr<Pace> scaled_pace(std::unique_ptr<Pace> pace, const TimeScale& scale);

}  // namespace echomap::session
