// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

/// hal/encoders for boards whose pins interrupt at each edge.
namespace echomap {
namespace boards {

/// What the encoders have done since the tick last took it, with room for 127 edges a millisecond
/// and wheel: forward positive, and how often both pins of a wheel had changed at once.
/// `count_edges` counts here; a board whose interrupt has no time for it does so by itself.
struct EncoderEdges {
  uint8_t before;  ///< Levels at the last edge, << 4.
  int8_t left;
  int8_t right;
  uint8_t left_lost;
  uint8_t right_lost;
};
extern EncoderEdges encoder_edges;

/// All counts are 0 from here on, and the pins have these levels. Bits: 0 left A, 1 left B, 2 right
/// A, 3 right B.
void start_edge_count(uint8_t levels);
/// From the pins' interrupt: one of them has changed, and these are the levels now.
void count_edges(uint8_t levels);
/// From the tick's interrupt.
void fold_edges();

/// All that has been counted, for a computer on which several programs take turns.
struct EdgeCount {
  EncoderEdges edges;
  int16_t left;
  int16_t right;
  uint16_t left_lost;
  uint16_t right_lost;
};
EdgeCount edge_count();
/// Goes on counting from there.
void resume_edge_count(const EdgeCount& count);

}  // namespace boards
}  // namespace echomap
