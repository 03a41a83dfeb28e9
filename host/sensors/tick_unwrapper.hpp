// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace echomap::sensors {

/// Extends a wheel's 16-bit counter to 64 bits, through wraps and resets of the robot.
class TickUnwrapper {
 public:
  /// Counts rolled since the first reading. Between two readings the wheel rolls less than 32 768
  /// counts either way; readings may come out of order.
  std::int64_t unwrap(std::int16_t ticks);

  /// The robot was reset: its counter starts at zero again, ours goes on.
  void restart() { last_ticks_ = 0; }

 private:
  std::int64_t total_ticks_ = 0;
  std::int16_t last_ticks_ = 0;
  bool started_ = false;
};

}  // namespace echomap::sensors
