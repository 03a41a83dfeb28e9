// SPDX-License-Identifier: MIT
#include "firmware/drivers/wheel_encoders.hpp"

#include "firmware/hal/interrupts.hpp"

namespace echomap {
namespace drivers {
namespace {

int16_t folded(int16_t count, int8_t edges, bool inverted) {
  return static_cast<int16_t>(inverted ? count - edges : count + edges);
}

}  // namespace

void WheelEncoders::invert(bool left, bool right) {
  const hal::InterruptLock lock;
  fold();
  left_inverted_ = left;
  right_inverted_ = right;
}

WheelCounts WheelEncoders::counts() {
  const hal::InterruptLock lock;
  fold();
  return counts_;
}

uint16_t WheelEncoders::errors() const {
  const hal::InterruptLock lock;
  return errors_;
}

void WheelEncoders::count_errors(uint8_t edges) {
  if ((edges & kLeftLost) != 0) {
    ++errors_;
  }
  if ((edges & kRightLost) != 0) {
    ++errors_;
  }
}

void WheelEncoders::fold() {
  counts_.left = folded(counts_.left, left_edges_, left_inverted_);
  counts_.right = folded(counts_.right, right_edges_, right_inverted_);
  left_edges_ = 0;
  right_edges_ = 0;
}

}  // namespace drivers
}  // namespace echomap
