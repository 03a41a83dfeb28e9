// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

namespace echomap {
namespace drivers {

/// Encoder counts of both wheels, modulo 2^16, forward positive.
struct WheelCounts {
  int16_t left;
  int16_t right;
};

/// Edges at which both pins of a wheel had changed, modulo 2^16.
struct WheelErrors {
  uint16_t left;
  uint16_t right;
};

/// Counts every edge of two quadrature encoders (x4): takes hal::encoder_edges, which have room for
/// 127 edges a millisecond and wheel, each tick.
class WheelEncoders {
 public:
  /// Takes the levels at the start, from where the first edge counts.
  static void start(uint8_t levels);
  /// Which encoders count backwards; past counts stay as they are.
  void invert(bool left, bool right);

  WheelCounts counts() const;
  WheelErrors errors() const;

  /// From the pins' interrupt; levels as in hal::on_encoder_pins.
  static void on_pins(uint8_t levels);

  /// From the tick's interrupt.
  void fold();

 private:
  bool left_inverted_ = false;
  bool right_inverted_ = false;
  WheelErrors errors_ = {0, 0};
  WheelCounts counts_ = {0, 0};
};

}  // namespace drivers
}  // namespace echomap
