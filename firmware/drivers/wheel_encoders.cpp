// SPDX-License-Identifier: MIT
#include "firmware/drivers/wheel_encoders.hpp"

#include "firmware/hal/encoders.hpp"

namespace echomap {
namespace drivers {

int16_t WheelEncoders::Wheel::count(int16_t read) const {
  return static_cast<int16_t>(is_inverted ? offset - read : offset + read);
}

void WheelEncoders::Wheel::invert(bool inverted, int16_t read) {
  const int16_t so_far = count(read);
  is_inverted = inverted;
  offset = static_cast<int16_t>(inverted ? so_far + read : so_far - read);
}

void WheelEncoders::invert(bool left, bool right) {
  const hal::EncoderReading reading = hal::read_encoders();
  left_.invert(left, reading.left);
  right_.invert(right, reading.right);
}

int16_t WheelEncoders::left_count() const { return left_.count(hal::read_encoders().left); }

int16_t WheelEncoders::right_count() const { return right_.count(hal::read_encoders().right); }

WheelCounts WheelEncoders::counts() const {
  const hal::EncoderReading reading = hal::read_encoders();
  return WheelCounts{left_.count(reading.left), right_.count(reading.right)};
}

}  // namespace drivers
}  // namespace echomap
