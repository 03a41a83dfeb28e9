// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "protocol/frame_encoder.hpp"
#include "tests/firmware/differential/random.hpp"

namespace echomap {
namespace differential {

/// A host that greets the robot, configures it at random, arms it and sends whatever comes to its
/// mind, extremes and damaged frames among it.
class RandomHost {
 public:
  constexpr explicit RandomHost(Random& random) : random_(random) {}

  /// Sends at most one frame. True when it starts again, with another configuration.
  bool step();

 private:
  template <class M>
  void send(const M& message);
  void begin();
  void send_anything();
  void send_motion();
  void send_drive_settings();
  void send_wiring();
  void send_pan_settings();
  void send_pin_settings();
  void send_safety_settings();
  void send_sweep();
  uint8_t pin_function();
  uint8_t next_id();
  uint16_t time_to_live_ms();
  int16_t speed();

  Random& random_;
  protocol::FrameEncoder encoder_{};
  uint8_t seq_ = 0;
  uint8_t command_id_ = 0;
  uint8_t opening_ = 0;  ///< The next message of `begin`.
};

}  // namespace differential
}  // namespace echomap
