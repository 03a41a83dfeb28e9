// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include "hil_mock/runner/simulated_board.hpp"
#include "hil_mock/unicorn/blue_pill_pins.hpp"
#include "hil_mock/unicorn/stm32_chip.hpp"

namespace echomap::unicorn {

/// The robot's Blue Pill: the release ELF on an emulated STM32F103, its pins as a SimulatedBoard.
/// Times are rounded up to whole CPU cycles of 13.9 ns.
class UnicornBoard final : public runner::SimulatedBoard {
 public:
  /// Loads `elf` and switches on at time 0. Throws std::runtime_error where it cannot be loaded.
  explicit UnicornBoard(const std::filesystem::path& elf);

  std::int64_t now_ns() const override;
  void run_until(std::int64_t until_ns) override;
  void reset() override { chip_.reset(ResetSource::kExternal); }

  void receive(std::span<const std::uint8_t> bytes) override { chip_.usart().receive(bytes); }

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
  /// The firmware of this board has no two-wire bus yet: nobody asks the device.
  void connect(world::TwoWireDevice& device) override { chip_.i2c2().connect(device); }

  std::string board_name() const override { return "stm32f103"; }
  std::string firmware_name() const override;
  std::string emulator_name() const override;

  /// The chip itself: cycles, resets, registers.
  Stm32Chip& chip() { return chip_; }
  const Stm32Chip& chip() const { return chip_; }

 private:
  void drive(Pin pin, bool level) { chip_.port(pin.port).drive(pin.number, level); }
  void drive_resting_levels();
  void on_trigger_level(bool high);
  void schedule_level(std::int64_t at_ns, Pin pin, bool level);

  std::string program_;
  Stm32Chip chip_;
  std::int64_t until_ns_ = 0;
  std::uint64_t trigger_rise_cycle_ = 0;
};

}  // namespace echomap::unicorn
