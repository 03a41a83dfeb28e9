// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

namespace echomap {
namespace drivers {

/// HC-SR04: a 10 us trigger is answered by a pulse as long as the echo's flight. A ping that
/// nothing answers holds the pulse for about 38 ms, some makes 200 ms; the next one has to wait for
/// its end.
class SonarHcSr04 {
 public:
  /// An echo pulse that has not begun by then will not come.
  static constexpr uint16_t kRiseTimeoutUs = 10000;

  /// True when a ping would be heard: the echo pin is low.
  static bool ready();
  /// Pings at `now_us`, whatever became of the last ping; takes 10 us.
  void ping(uint32_t now_us);
  /// True once when the ping is answered or given up; `flight_us` is then there and back, or
  /// protocol::kNoEcho for an echo later than `max_echo_us` or none, protocol::kNoSonar where not
  /// even the pulse has begun.
  bool poll(uint32_t now_us, uint16_t max_echo_us, uint16_t& flight_us);

  /// From the capture interrupt, see hal::on_echo_edge.
  void on_echo_edge(bool high, uint32_t stamp_half_us);

 private:
  enum class State : uint8_t { kIdle, kTriggered, kHigh, kAnswered };

  /// The interrupt steps it on, and leaves the stamps alone once it is kAnswered: no lock is
  /// needed.
  volatile State state_ = State::kIdle;
  uint32_t pinged_us_ = 0;
  volatile uint32_t rise_half_us_ = 0;
  volatile uint32_t fall_half_us_ = 0;
};

}  // namespace drivers
}  // namespace echomap
