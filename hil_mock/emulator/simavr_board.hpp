// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include "hil_mock/emulator/avr_machine.hpp"
#include "hil_mock/emulator/board_wiring.hpp"
#include "hil_mock/emulator/held_bus.hpp"
#include "hil_mock/emulator/output_pins.hpp"
#include "hil_mock/runner/simulated_board.hpp"

namespace echomap::emulator {

/// A robot's AVR board: the release ELF on the emulated chip that it is for, that board's pins as a
/// SimulatedBoard. Times are rounded up to whole CPU cycles of 62.5 ns.
class SimavrBoard final : public runner::SimulatedBoard {
 public:
  /// Loads `elf` and switches on at time 0. Throws std::runtime_error where it cannot be loaded.
  explicit SimavrBoard(const std::filesystem::path& elf);

  std::int64_t now_ns() const override;
  void run_until(std::int64_t until_ns) override;
  void reset() override { machine_.reset(ResetSource::kExternal); }

  void receive(std::span<const std::uint8_t> bytes) override { machine_.usart().receive(bytes); }

  world::DriverInputs driver_inputs(runner::Wheel wheel,
                                    world::DriverInterface interface) const override;
  double pan_pulse_us() const override;
  void schedule_encoder_edge(runner::Wheel wheel, std::int64_t at_ns, bool a, bool b) override;
  void schedule_echo(std::int64_t rise_ns, std::int64_t fall_ns) override;
  void set_bump(runner::Wheel side, bool pressed) override;

  /// Throws std::invalid_argument, as the next two, for a pin that cannot be that.
  void set_aux_level(unsigned pin, bool high) override;
  void schedule_aux_pulse(unsigned pin, std::int64_t fall_ns, std::int64_t rise_ns) override;
  void set_aux_millivolts(unsigned pin, double millivolts) override;
  bool aux_output(unsigned pin) const override;
  void connect(world::TwoWireDevice& device) override;

  std::string board_name() const override { return wiring_.board; }
  std::string firmware_name() const override;
  std::string emulator_name() const override;

  /// The chip itself: cycles, resets, registers.
  AvrMachine& machine() { return machine_; }
  const AvrMachine& machine() const { return machine_; }
  const BoardWiring& wiring() const { return wiring_; }
  /// The wires of the two-wire bus.
  HeldBus& two_wire_bus() { return two_wire_bus_; }

 private:
  const SparePin& spare_pin(unsigned pin) const;
  /// One that has a level.
  Pin digital_pin(unsigned pin) const;
  void drive_resting_levels();
  void watch_trigger();
  void on_trigger_level(bool high);
  void watch_servo();
  void watch_motors();
  void tell_duty() const;
  void schedule_level(std::int64_t at_ns, Pin pin, bool level);

  std::string program_;
  const BoardWiring& wiring_;
  AvrMachine machine_;
  MotorOutput left_motor_;
  MotorOutput right_motor_;
  PwmOutput servo_;
  HeldBus two_wire_bus_;
  PortOutput trigger_;
  std::int64_t until_ns_ = 0;
  std::uint64_t trigger_rise_cycle_ = 0;
  bool trigger_high_ = false;
  std::uint16_t servo_compare_ = 0;
};

}  // namespace echomap::emulator
