// SPDX-License-Identifier: MIT
#include "firmware/boards/edge_counter/edge_counter.hpp"

#include "firmware/boards/edge_counter/quadrature_table.hpp"
#include "firmware/hal/clock.hpp"
#include "firmware/hal/encoders.hpp"
#include "firmware/hal/interrupts.hpp"

namespace echomap {
namespace boards {

EncoderEdges encoder_edges;

namespace {

/// Up to the last tick.
struct Folded {
  int16_t left;
  int16_t right;
  uint16_t left_lost;
  uint16_t right_lost;
};

Folded folded;

void add(int8_t& edges, uint8_t forward, uint8_t backward) {
  if (forward != 0) {
    ++edges;
  }
  if (backward != 0) {
    --edges;
  }
}

int16_t sum(int16_t count, int8_t edges) { return static_cast<int16_t>(count + edges); }
uint16_t sum(uint16_t count, uint8_t edges) { return static_cast<uint16_t>(count + edges); }

}  // namespace

void start_edge_count(uint8_t levels) {
  folded = Folded{0, 0, 0, 0};
  encoder_edges = EncoderEdges{static_cast<uint8_t>(levels << 4), 0, 0, 0, 0};
}

void count_edges(uint8_t levels) {
  EncoderEdges& edges = encoder_edges;
  const uint8_t index = static_cast<uint8_t>(edges.before | levels);
  edges.before = static_cast<uint8_t>(levels << 4);
  const uint8_t found = hal::read_flash(&kQuadratureTable.edges[index]);
  add(edges.left, found & kLeftForward, found & kLeftBackward);
  add(edges.right, found & kRightForward, found & kRightBackward);
  if ((found & kLeftLost) != 0) {
    ++edges.left_lost;
  }
  if ((found & kRightLost) != 0) {
    ++edges.right_lost;
  }
}

void fold_edges() {
  EncoderEdges& edges = encoder_edges;
  folded.left = sum(folded.left, edges.left);
  folded.right = sum(folded.right, edges.right);
  edges.left = 0;
  edges.right = 0;
  if ((edges.left_lost | edges.right_lost) == 0) {
    return;
  }
  folded.left_lost = sum(folded.left_lost, edges.left_lost);
  folded.right_lost = sum(folded.right_lost, edges.right_lost);
  edges.left_lost = 0;
  edges.right_lost = 0;
}

EdgeCount edge_count() {
  return EdgeCount{encoder_edges, folded.left, folded.right, folded.left_lost, folded.right_lost};
}

void resume_edge_count(const EdgeCount& count) {
  encoder_edges = count.edges;
  folded = Folded{count.left, count.right, count.left_lost, count.right_lost};
}

}  // namespace boards

namespace hal {

EncoderReading read_encoders() {
  using namespace boards;
  const InterruptLock lock;
  return EncoderReading{sum(folded.left, encoder_edges.left),
                        sum(folded.right, encoder_edges.right)};
}

uint32_t encoders_read_at_us() { return now_us(); }

LostSteps lost_encoder_steps() {
  using namespace boards;
  const InterruptLock lock;
  return LostSteps{sum(folded.left_lost, encoder_edges.left_lost),
                   sum(folded.right_lost, encoder_edges.right_lost)};
}

bool encoders_tell_lost_steps() { return true; }

}  // namespace hal
}  // namespace echomap
