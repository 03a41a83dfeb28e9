// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "firmware/drivers/quadrature_table.hpp"

namespace echomap {
namespace drivers {

/// Encoder counts of both wheels, modulo 2^16, forward positive.
struct WheelCounts {
  int16_t left;
  int16_t right;
};

/// Counts every edge of two quadrature encoders (x4). The interrupt adds to bytes, which are folded
/// into the counts each tick: room for 127 edges a millisecond and wheel.
class WheelEncoders {
 public:
  /// Takes the levels at the start, from where the first edge counts.
  void start(uint8_t levels) { before_ = static_cast<uint8_t>(levels << 4); }
  /// Which encoders count backwards; past counts stay as they are.
  void invert(bool left, bool right);

  WheelCounts counts();
  /// Edges at which both pins of a wheel had changed.
  uint16_t errors() const;

  /// From the pins' interrupt; levels as in hal::on_encoder_pins.
  void on_pins(uint8_t levels) {
    const uint8_t index = static_cast<uint8_t>(before_ | levels);
    before_ = static_cast<uint8_t>(levels << 4);
    const uint8_t edges = hal::read_flash(&kQuadratureTable.edges[index]);
    add(left_edges_, edges & kLeftForward, edges & kLeftBackward);
    add(right_edges_, edges & kRightForward, edges & kRightBackward);
    if ((edges & (kLeftLost | kRightLost)) != 0) {
      count_errors(edges);
    }
  }

  /// From the tick's interrupt.
  void fold();

 private:
  static void add(int8_t& edges, uint8_t forward, uint8_t backward) {
    int8_t sum = edges;
    if (forward != 0) {
      ++sum;
    }
    if (backward != 0) {
      --sum;
    }
    edges = sum;
  }
  void count_errors(uint8_t edges);

  uint8_t before_ = 0;
  int8_t left_edges_ = 0;
  int8_t right_edges_ = 0;
  bool left_inverted_ = false;
  bool right_inverted_ = false;
  uint16_t errors_ = 0;
  WheelCounts counts_ = {0, 0};
};

}  // namespace drivers
}  // namespace echomap
