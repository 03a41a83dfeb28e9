// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "firmware/drivers/range_sonar.hpp"
#include "firmware/drivers/sonar_hc_sr04.hpp"
#include "firmware/hal/range_sensor.hpp"

namespace echomap {
namespace drivers {

/// What measures ranges, an HC-SR04 that the firmware times or a sensor that measures by itself, by
/// board.
class Sonar {
 public:
  /// True when a ping would be heard.
  static bool ready() { return hal::has_range_sensor() || SonarHcSr04::ready(); }
  /// Pings at `now_us`, whatever became of the last ping.
  void ping(uint32_t now_us) {
    if (hal::has_range_sensor()) {
      range_.ping(now_us);
    } else {
      echo_.ping(now_us);
    }
  }
  /// True once when the ping is answered or given up, as SonarHcSr04::poll.
  bool poll(uint32_t now_us, uint16_t max_echo_us, uint16_t& flight_us) {
    return hal::has_range_sensor() ? range_.poll(now_us, max_echo_us, flight_us)
                                   : echo_.poll(now_us, max_echo_us, flight_us);
  }
  /// From the capture interrupt, see hal::on_echo_edge.
  void on_echo_edge(bool high, uint32_t stamp_half_us) { echo_.on_echo_edge(high, stamp_half_us); }

 private:
  SonarHcSr04 echo_;
  RangeSonar range_;
};

}  // namespace drivers
}  // namespace echomap
