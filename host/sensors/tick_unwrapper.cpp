// SPDX-License-Identifier: MIT
#include "host/sensors/tick_unwrapper.hpp"

namespace echomap::sensors {

std::int64_t TickUnwrapper::unwrap(std::int16_t ticks) {
  if (started_) {
    total_ticks_ += static_cast<std::int16_t>(static_cast<std::uint16_t>(ticks) -
                                              static_cast<std::uint16_t>(last_ticks_));
  }
  started_ = true;
  last_ticks_ = ticks;
  return total_ticks_;
}

}  // namespace echomap::sensors
