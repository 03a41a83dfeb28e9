// SPDX-License-Identifier: MIT
#include "tests/firmware/differential/world.hpp"

#include "firmware/hal/contacts.hpp"
#include "firmware/hal/encoders.hpp"
#include "firmware/hal/events.hpp"

namespace echomap {
namespace differential {
namespace {

constexpr int32_t kMaxEdges = 127;

int32_t clamped(int32_t value, int32_t limit) {
  if (value > limit) {
    return limit;
  }
  return value < -limit ? -limit : value;
}

/// A wheel's signed way: any size up to the most edges, half of them small.
int32_t jump(Random& random) {
  const uint16_t drawn = random.bits16();
  const uint8_t size = static_cast<uint8_t>(drawn & 0x7FU) >> ((drawn >> 8) & 7U);
  return (drawn & 0x8000U) != 0 ? -int32_t{size} : int32_t{size};
}

}  // namespace

void Wheel::change(Random& random) {
  const uint16_t drawn = random.bits16();
  const uint8_t kind = drawn & 15U;
  kind_ = kind < 8 ? Kind::kFollows : static_cast<Kind>(1 + (kind & 3U));
  gain_ = static_cast<uint8_t>(1 + ((drawn >> 4) & 0x7FU) % (kMaxEdges - 1));
  inertia_ = static_cast<uint8_t>((drawn >> 11) & 7U);
  pushed_ = static_cast<int16_t>(random.wide());
}

int8_t Wheel::step(Random& random) {
  if (kind_ == Kind::kBlocked) {
    return 0;
  }
  if (kind_ == Kind::kJumps) {
    return static_cast<int8_t>(jump(random));
  }
  int32_t target = int32_t{duty_} * gain_;
  if (kind_ == Kind::kReversed) {
    target = -target;
  } else if (kind_ == Kind::kPushed) {
    target += pushed_;
  }
  speed_ += (clamped(target, kMaxEdges * 256) - speed_) >> inertia_;
  const int32_t way = speed_ + remainder_;
  remainder_ = static_cast<uint8_t>(way & 0xFF);
  return static_cast<int8_t>(clamped(way >> 8, kMaxEdges));
}

void World::step() {
  now_us_ += 1000;
  encoders_.left = static_cast<int16_t>(encoders_.left + left_.step(random_));
  encoders_.right = static_cast<int16_t>(encoders_.right + right_.step(random_));
  const uint32_t drawn = random_.next();
  pulses_ = static_cast<uint8_t>(pulses_ + (static_cast<uint8_t>(drawn >> 24) & 3U));
  if ((drawn & ((uint32_t{1} << calm_) - 1)) == 0) {
    const uint8_t both = static_cast<uint8_t>(drawn >> 16) & 7U;
    contacts_ = both & (hal::kContactLeft | hal::kContactRight);
    aux_levels_ = (drawn >> 31) != 0 ? random_.bits16() : uint16_t{0xFFFF};
    lost_steps_.left = static_cast<uint16_t>(lost_steps_.left + (both >> 2));
    lost_steps_.right =
        static_cast<uint16_t>(lost_steps_.right + (static_cast<uint8_t>(drawn >> 19) & 1U));
  }
  step_echo();
}

void World::step_echo() {
  if (echo_ == Echo::kLow || echo_ms_ == 0xFF || echo_ms_-- != 0) {
    return;
  }
  const uint32_t stamp_half_us = now_us_ * 2 + (random_.bits16() & 1023U);
  const bool rises = echo_ == Echo::kTriggered;
  echo_ = rises ? Echo::kHigh : Echo::kLow;
  const uint16_t drawn = random_.bits16();
  echo_ms_ = static_cast<uint8_t>(static_cast<uint8_t>(drawn) >> ((drawn >> 8) & 7U));
  hal::on_echo_edge(rises, stamp_half_us);
}

void World::drain() {
  for (uint8_t left = static_cast<uint8_t>(line_bytes_per_s_ >> 10) + 1; left != 0; --left) {
    uint8_t byte = 0;
    if (!hal::next_byte_to_send(byte)) {
      return;
    }
    output(Output::kByteSent, byte);
  }
}

void World::change() {
  constexpr uint16_t kBytesPerS[4] = {960, 11520, 25000, 50000};
  const uint16_t drawn = random_.bits16();
  line_bytes_per_s_ = kBytesPerS[drawn & 3U];
  calm_ = static_cast<uint8_t>(6 + ((drawn >> 2) & 7U));
  left_.change(random_);
  right_.change(random_);
}

void World::set_motor(hal::Motor motor, bool forward, uint8_t duty) {
  const uint16_t side = static_cast<uint16_t>(motor);
  output(Output::kMotor, static_cast<uint16_t>((side << 9) | (forward ? 0x100U : 0U) | duty));
  (motor == hal::Motor::kLeft ? left_ : right_).set(forward, duty);
}

void World::stop_motor(hal::Motor motor, bool brake) {
  const uint16_t side = static_cast<uint16_t>(motor);
  output(Output::kMotorStop, static_cast<uint16_t>((side << 1) | (brake ? 1U : 0U)));
  (motor == hal::Motor::kLeft ? left_ : right_).set(true, 0);
}

void World::trigger_sonar() {
  output(Output::kTrigger, 0);
  const uint8_t drawn = random_.bits8();
  echo_ = Echo::kTriggered;
  echo_ms_ = drawn < 8 ? uint8_t{0xFF} : static_cast<uint8_t>(drawn & 15U);
}

void World::start_two_wire() {
  const uint32_t drawn = random_.next();
  two_wire_ = (drawn & 63U) == 0 ? hal::TwiState::kFailed : hal::TwiState::kDone;
  two_wire_value_ = static_cast<int16_t>(drawn >> 16);
}

hal::TwiState World::two_wire_state(int16_t& value) {
  if (two_wire_ == hal::TwiState::kIdle || random_.once_in(2)) {
    return two_wire_ == hal::TwiState::kIdle ? hal::TwiState::kIdle : hal::TwiState::kBusy;
  }
  value = two_wire_value_;
  return two_wire_;
}

}  // namespace differential
}  // namespace echomap
