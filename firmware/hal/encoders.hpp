// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

namespace echomap {
namespace hal {

/// Levels of the encoder pins now, bits as in `on_encoder_pins`.
uint8_t encoder_levels();

/// What the encoders have done since the tick last took it: edges of each wheel, forward positive,
/// and how often both pins of a wheel had changed at once. `on_encoder_pins` counts here; a board
/// whose interrupt has no time for it counts here by itself.
struct EncoderEdges {
  uint8_t before;  ///< Levels at the last edge, << 4.
  int8_t left;
  int8_t right;
  uint8_t left_lost;
  uint8_t right_lost;
};
extern EncoderEdges encoder_edges;

}  // namespace hal
}  // namespace echomap
