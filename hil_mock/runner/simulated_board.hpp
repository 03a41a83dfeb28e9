// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>

#include "hil_mock/world/motor_driver.hpp"
#include "hil_mock/world/two_wire_device.hpp"

namespace echomap::runner {

/// The two wheels, as seen from behind the robot.
enum class Wheel : std::uint8_t { kLeft, kRight };

/// What the motors get from their drivers.
using MotorDuty = world::WheelDuty;

/// A robot's board in simulated time, seen from its pins: the emulated AVR or the native firmware.
/// Times are nanoseconds since power-on. Events may only be scheduled at or after `now_ns()`.
class SimulatedBoard {
 public:
  virtual ~SimulatedBoard() = default;

  virtual std::int64_t now_ns() const = 0;
  /// Runs the board's program up to `until_ns`; calls the hooks below from within.
  virtual void run_until(std::int64_t until_ns) = 0;
  /// Pulls the reset pin: the program starts again, time goes on.
  virtual void reset() = 0;

  /// Bytes on the board's receive line, paced by its baud rate.
  virtual void receive(std::span<const std::uint8_t> bytes) = 0;
  /// The line's cable is put in again or pulled out; a board without a plug does not notice.
  virtual void plug_line(bool /*in*/) {}
  /// Called with each byte that the board has sent, when its stop bit is over.
  std::function<void(std::uint8_t)> on_sent;

  /// What the board puts on the wires to a motor's driver, which are those that the firmware has
  /// for this interface. Pins that the board has none of float.
  virtual world::DriverInputs driver_inputs(Wheel wheel,
                                            world::DriverInterface interface) const = 0;
  /// What drivers of this kind make of that.
  MotorDuty motor_duty(const world::MotorDriver& driver = world::MotorDriver()) const;
  /// Called at the instant at which the program or a reset may have changed them.
  std::function<void()> on_duty;
  /// Length of the servo pulse now produced; 0 before the first.
  virtual double pan_pulse_us() const = 0;
  /// The quadrature pins of a wheel change to these levels at `at_ns`.
  virtual void schedule_encoder_edge(Wheel wheel, std::int64_t at_ns, bool a, bool b) = 0;
  /// Called when the board has triggered the sonar; answer with `schedule_echo` or not at all.
  std::function<void(std::int64_t at_ns)> on_trigger;
  virtual void schedule_echo(std::int64_t rise_ns, std::int64_t fall_ns) = 0;
  /// The contact of that side is closed or open from now on.
  virtual void set_bump(Wheel side, bool closed) = 0;

  /// Puts a level on a spare pin, numbered as in protocol::ConfigurePins, until it is changed;
  /// before that an input is high by its pull-up.
  virtual void set_aux_level(unsigned pin, bool high) = 0;
  /// A spare pin is low for so long, and then high again.
  virtual void schedule_aux_pulse(unsigned pin, std::int64_t fall_ns, std::int64_t rise_ns) = 0;
  /// The same as a level for a pin that the converter reads, 0 .. 5000.
  virtual void set_aux_millivolts(unsigned pin, double millivolts) = 0;
  /// Level that the program gives a spare pin; false where it is no output.
  virtual bool aux_output(unsigned pin) const = 0;
  /// Puts a device on the two-wire bus; it must outlive the board.
  virtual void connect(world::TwoWireDevice& device) = 0;

  /// As the [wiring] tables of robots call the board: "uno".
  virtual std::string board_name() const = 0;
  /// What runs and in what, for summaries: for example "echomap-uno 0.1.0" and "simavr 1.6".
  virtual std::string firmware_name() const = 0;
  virtual std::string emulator_name() const = 0;
};

}  // namespace echomap::runner
