// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

namespace echomap {
namespace drivers {

/// A sensor that measures by itself in the manner of a sonar: a ping is answered by the first
/// reading that has surely been measured after it, its range turned back into a flight time.
class RangeSonar {
 public:
  /// Asks for a range measured from `now_us` on, whatever became of the last ping.
  void ping(uint32_t now_us);
  /// True once, with the flight time there and back, or protocol::kNoEcho for one above
  /// `max_echo_us` or none, protocol::kNoSonar where there is no sensor.
  bool poll(uint32_t now_us, uint16_t max_echo_us, uint16_t& flight_us);

 private:
  uint32_t pinged_us_ = 0;
  bool listening_ = false;
};

}  // namespace drivers
}  // namespace echomap
