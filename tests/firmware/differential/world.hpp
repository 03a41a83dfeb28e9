// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "firmware/hal/encoders.hpp"
#include "firmware/hal/motors.hpp"
#include "firmware/hal/twi.hpp"
#include "tests/firmware/differential/random.hpp"
#include "tests/firmware/differential/trace.hpp"

namespace echomap {
namespace differential {

/// A wheel that follows its motor, or does not.
class Wheel {
 public:
  /// Draws another behaviour: follows at some speed, is blocked, runs the wrong way round, is
  /// pushed, or jumps about.
  void change(Random& random);
  void set(bool forward, uint8_t duty) {
    duty_ = static_cast<int16_t>(forward ? int16_t{duty} : -int16_t{duty});
  }
  /// Edges of the next millisecond, -127 .. 127.
  int8_t step(Random& random);

 private:
  enum class Kind : uint8_t { kFollows, kReversed, kPushed, kBlocked, kJumps };

  Kind kind_ = Kind::kFollows;
  uint8_t gain_ = 13;      ///< Edges/256 a millisecond and duty.
  uint8_t inertia_ = 5;    ///< Time constant: 2 to this power, milliseconds.
  int16_t pushed_ = 0;     ///< Edges/256 a millisecond.
  int16_t duty_ = 0;       ///< -255 .. 255.
  int32_t speed_ = 0;      ///< Edges/256 a millisecond.
  uint8_t remainder_ = 0;  ///< Edges/256.
};

/// What the firmware sees through its hardware layer, a random one, and a trace of what it does.
/// No number here depends on the width of int, and no expression draws two of them: their order
/// would be the compiler's choice.
class World {
 public:
  constexpr explicit World(uint32_t seed) : random_(seed) {}

  /// The next millisecond: wheels turn, contacts, pins and the echo change.
  void step();
  /// Takes what the line sends in a millisecond.
  void drain();
  /// Other wheels, another line, other readings.
  void change();

  Random& random() { return random_; }
  const Trace& trace() const { return trace_; }

  // The hardware layer.
  uint32_t now_us() const { return now_us_; }
  const hal::EncoderReading& encoders() const { return encoders_; }
  const hal::LostSteps& lost_steps() const { return lost_steps_; }
  uint8_t contacts() const { return contacts_; }
  uint16_t aux_levels() const { return aux_levels_; }
  uint8_t pulses() const { return pulses_; }
  bool echo_is_high() const { return echo_ == Echo::kHigh; }
  uint16_t line_bytes_per_s() const { return line_bytes_per_s_; }
  void output(Output kind, uint16_t value) { trace_.add(kind, value); }
  void set_motor(hal::Motor motor, bool forward, uint8_t duty);
  void stop_motor(hal::Motor motor, bool brake);
  void trigger_sonar();
  uint16_t conversion() { return random_.bits16() & 1023U; }
  void start_two_wire();
  hal::TwiState two_wire_state(int16_t& value);
  void stop_two_wire() { two_wire_ = hal::TwiState::kIdle; }

 private:
  enum class Echo : uint8_t { kLow, kTriggered, kHigh };

  void step_echo();

  Random random_;
  Trace trace_ = {0, 0};
  uint32_t now_us_ = 0xFFF00000UL;  // Over the end of its 32 bits in a second.
  uint16_t line_bytes_per_s_ = 11520;
  uint16_t aux_levels_ = 0xFFFF;
  hal::EncoderReading encoders_ = {0, 0};
  hal::LostSteps lost_steps_ = {0, 0};
  uint8_t contacts_ = 0;
  uint8_t pulses_ = 0;
  uint8_t calm_ = 8;  ///< Contacts and pins change once in 2 to this power.
  Echo echo_ = Echo::kLow;
  uint8_t echo_ms_ = 0;  ///< To the next edge.
  hal::TwiState two_wire_ = hal::TwiState::kIdle;
  int16_t two_wire_value_ = 0;
  Wheel left_;
  Wheel right_;
};

/// The one that the hardware layer shows.
extern World world;

}  // namespace differential
}  // namespace echomap
