// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <optional>

#include "firmware/boards/native/native_two_wire.hpp"
#include "firmware/boards/native/program_memory.hpp"
#include "firmware/hal/aux_pins.hpp"
#include "firmware/hal/contacts.hpp"
#include "firmware/hal/motors.hpp"
#include "firmware/hal/range_sensor.hpp"

namespace echomap {
namespace native {

/// The Uno's firmware on this computer, in simulated time: the same portable program behind the
/// pins of a board that goes from event to event (tick, byte, edge) and lets the program work until
/// it has nothing to do. The program takes no time. There is one program's memory in the process;
/// boards take turns in it, each with its own memory kept while another one runs. `power_on` starts
/// the program over, with the same behaviour every time.
class NativeBoard {
 public:
  /// One byte at 250000 baud, which the Uno's divider makes exactly.
  static constexpr std::int64_t kByteNs = 40000;
  /// Spare pins; each can be anything.
  static constexpr std::uint8_t kAuxPins = 16;

  NativeBoard() = default;
  ~NativeBoard();
  /// The board whose program is in the memory: the one that ran last, and before any other a board
  /// that is there from the beginning.
  static NativeBoard& instance();
  NativeBoard(const NativeBoard&) = delete;
  NativeBoard& operator=(const NativeBoard&) = delete;

  /// Back to time 0: forgets all events and bytes under way and starts the program anew. Hooks and
  /// what contacts and spare pins see from outside stay, encoder and echo pins are low.
  void power_on();
  /// Pulls the reset pin: time goes on, the program and its clock start again. Edges of encoders
  /// and echo that are under way are lost.
  void reset() { start_program(); }

  /// How often the program has started since `power_on`, that start included.
  std::uint16_t starts() const { return starts_; }
  /// Since the program's last start.
  std::int64_t program_ns() const { return now_ns_ - started_ns_; }
  /// Simulated time since `power_on`.
  std::int64_t now_ns() const { return now_ns_; }
  /// Serves every event up to and including this time.
  void run_until_ns(std::int64_t until_ns);

  /// Puts bytes on the receive line, which delivers one every kByteNs.
  void receive(const std::uint8_t* bytes, std::size_t size);
  /// Called with each byte sent, when its stop bit is over.
  std::function<void(std::uint8_t)> on_sent;

  /// Called when the sonar is triggered, with the time; may call `schedule_echo`.
  std::function<void(std::int64_t)> on_trigger;
  /// The echo pin will go high and low at these times, which are not in the past.
  void schedule_echo(std::int64_t rise_ns, std::int64_t fall_ns);

  /// Duty of the motors, -255 .. 255, forward positive.
  std::int16_t left_duty() const { return left_duty_; }
  std::int16_t right_duty() const { return right_duty_; }
  /// What the motors are connected to, and whether their PWM is the slow one.
  hal::BridgeKind bridge_kind() const { return bridge_kind_; }
  bool has_slow_pwm() const { return has_slow_pwm_; }
  /// True for a motor at rest that is braked.
  bool left_brakes() const { return left_brakes_; }
  bool right_brakes() const { return right_brakes_; }
  /// Called when the program has set one of them.
  std::function<void()> on_motor;
  /// Length of the servo's pulses; 0 before the first.
  double pan_pulse_us() const { return pan_pulse_us_; }

  /// A wheel's encoder pins will have these levels from this time on, which is not in the past. A
  /// leads B forwards.
  void schedule_encoder_edge(bool right, std::int64_t at_ns, bool a, bool b);
  /// Closes or opens a bump contact now.
  void set_bump(bool right, bool closed);

  /// Level on a spare pin from now on; high, by its pull-up, before the first call. A falling edge
  /// of a pin whose pulses the program counts is one.
  void set_aux_level(std::uint8_t pin, bool high);
  /// A spare pin is low for so long, from a time on that is not in the past.
  void schedule_aux_pulse(std::uint8_t pin, std::int64_t fall_ns, std::int64_t rise_ns);
  /// What the converter reads on a spare pin from now on, 0 .. 1023; 0 before the first call.
  void set_aux_analog(std::uint8_t pin, std::uint16_t raw) { aux_analog_.at(pin) = raw; }
  /// What the program uses a spare pin for.
  hal::PinUse aux_use(std::uint8_t pin) const { return aux_uses_.at(pin); }
  /// Level that the program gives a spare pin; false where it is no output.
  bool aux_output(std::uint8_t pin) const { return aux_outputs_.at(pin); }
  /// Called when that level changes, with the time.
  std::function<void(std::int64_t, std::uint8_t, bool)> on_aux_output;

  /// The two-wire bus and its devices; a bit for each spare pin that it takes, none at first.
  NativeTwoWire two_wire;
  std::uint16_t twi_aux_pins = 0;

  /// A sonar that measures by itself, and what it says; without one there is the HC-SR04.
  std::optional<hal::RangeReading> range_sensor;
  /// A gyro that sums up by itself, and what it says, if anything.
  bool has_yaw_gyro = false;
  std::optional<std::int16_t> yaw_deg;

  /// How often the program has kicked the watchdog.
  std::uint32_t watchdog_kicks() const { return watchdog_kicks_; }

  /// What the functions of firmware/hal do on this board.
  void use_bridge(hal::BridgeKind kind, bool slow_pwm);
  void set_motor(hal::Motor motor, std::int16_t duty, bool brakes);
  void set_pan_pulse_us(std::uint16_t pulse_us) { pan_pulse_us_ = pulse_us; }
  void trigger_sonar();
  bool echo_is_high() const { return echo_high_; }
  std::uint8_t closed_contacts() const { return closed_contacts_; }
  void use_aux_pin(std::uint8_t pin, hal::PinUse use);
  std::uint16_t aux_levels() const;
  void set_aux_output(std::uint8_t pin, bool high);
  void start_conversion(std::uint8_t pin);
  bool conversion_done(std::uint16_t& value) const;
  std::uint8_t counted_pulses() const { return counted_pulses_; }
  void request_send();
  void kick_watchdog() { ++watchdog_kicks_; }

 private:
  using Event = std::function<void()>;

  void take_memory();
  void start_program();
  void at(std::int64_t at_ns, Event event) { events_.emplace(at_ns, std::move(event)); }
  void tick();
  void deliver_byte();
  void finish_byte(std::uint8_t byte);
  void set_echo(bool high);
  void set_encoder(bool right, bool a, bool b);

  std::optional<ProgramMemory> memory_;  ///< Of the program while another one is in the memory.
  std::multimap<std::int64_t, Event> events_;  ///< Equal times in the order of scheduling.
  std::deque<std::uint8_t> line_;
  std::int64_t now_ns_ = 0;
  std::int64_t started_ns_ = 0;
  std::uint16_t starts_ = 0;
  bool sending_ = false;
  bool echo_high_ = false;
  std::uint8_t encoder_levels_ = 0;
  std::uint8_t closed_contacts_ = 0;
  std::int16_t left_duty_ = 0;
  std::int16_t right_duty_ = 0;
  bool left_brakes_ = false;
  bool right_brakes_ = false;
  hal::BridgeKind bridge_kind_ = hal::BridgeKind::kPhaseEnable;
  bool has_slow_pwm_ = false;
  double pan_pulse_us_ = 0.0;
  std::array<hal::PinUse, kAuxPins> aux_uses_ = {};
  std::array<bool, kAuxPins> aux_outputs_ = {};
  std::array<std::uint16_t, kAuxPins> aux_analog_ = {};
  std::uint8_t counted_pulses_ = 0;
  std::uint16_t aux_low_ = 0;  ///< A bit for each spare pin that something pulls low.
  std::uint16_t converted_ = 0;
  std::int64_t conversion_end_ns_ = 0;
  std::uint32_t watchdog_kicks_ = 0;
};

}  // namespace native
}  // namespace echomap
