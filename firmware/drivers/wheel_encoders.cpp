// SPDX-License-Identifier: MIT
#include "firmware/drivers/wheel_encoders.hpp"

#include "firmware/hal/encoders.hpp"
#include "firmware/hal/interrupts.hpp"
#include "firmware/hal/quadrature_table.hpp"

namespace echomap {
namespace hal {

EncoderEdges encoder_edges;

}  // namespace hal

namespace drivers {
namespace {

void add(int8_t& edges, uint8_t forward, uint8_t backward) {
  if (forward != 0) {
    ++edges;
  }
  if (backward != 0) {
    --edges;
  }
}

int16_t folded(int16_t count, int8_t edges, bool inverted) {
  return static_cast<int16_t>(inverted ? count - edges : count + edges);
}

}  // namespace

void WheelEncoders::start(uint8_t levels) {
  hal::encoder_edges = hal::EncoderEdges{static_cast<uint8_t>(levels << 4), 0, 0, 0, 0};
}

void WheelEncoders::invert(bool left, bool right) {
  const hal::InterruptLock lock;
  fold();
  left_inverted_ = left;
  right_inverted_ = right;
}

WheelCounts WheelEncoders::counts() const {
  const hal::InterruptLock lock;
  return WheelCounts{folded(counts_.left, hal::encoder_edges.left, left_inverted_),
                     folded(counts_.right, hal::encoder_edges.right, right_inverted_)};
}

WheelErrors WheelEncoders::errors() const {
  const hal::InterruptLock lock;
  const hal::EncoderEdges& edges = hal::encoder_edges;
  return WheelErrors{static_cast<uint16_t>(errors_.left + edges.left_lost),
                     static_cast<uint16_t>(errors_.right + edges.right_lost)};
}

void WheelEncoders::on_pins(uint8_t levels) {
  hal::EncoderEdges& edges = hal::encoder_edges;
  const uint8_t index = static_cast<uint8_t>(edges.before | levels);
  edges.before = static_cast<uint8_t>(levels << 4);
  const uint8_t found = hal::read_flash(&hal::kQuadratureTable.edges[index]);
  add(edges.left, found & hal::kLeftForward, found & hal::kLeftBackward);
  add(edges.right, found & hal::kRightForward, found & hal::kRightBackward);
  if ((found & hal::kLeftLost) != 0) {
    ++edges.left_lost;
  }
  if ((found & hal::kRightLost) != 0) {
    ++edges.right_lost;
  }
}

void WheelEncoders::fold() {
  hal::EncoderEdges& edges = hal::encoder_edges;
  counts_.left = folded(counts_.left, edges.left, left_inverted_);
  counts_.right = folded(counts_.right, edges.right, right_inverted_);
  edges.left = 0;
  edges.right = 0;
  if ((edges.left_lost | edges.right_lost) == 0) {
    return;
  }
  errors_.left = static_cast<uint16_t>(errors_.left + edges.left_lost);
  errors_.right = static_cast<uint16_t>(errors_.right + edges.right_lost);
  edges.left_lost = 0;
  edges.right_lost = 0;
}

}  // namespace drivers
}  // namespace echomap
