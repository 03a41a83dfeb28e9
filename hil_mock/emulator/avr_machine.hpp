// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <sim_avr.h>

#include "hil_mock/emulator/analog_inputs.hpp"
#include "hil_mock/emulator/cycle_queue.hpp"
#include "hil_mock/emulator/input_pins.hpp"
#include "hil_mock/emulator/register_hooks.hpp"
#include "hil_mock/emulator/reset_watcher.hpp"
#include "hil_mock/emulator/two_wire.hpp"
#include "hil_mock/emulator/usart0.hpp"

namespace echomap::emulator {

/// Cycles of the emulated chip in a second of simulated time.
constexpr std::uint32_t kClockHz = 16'000'000;

/// What pulled the chip's reset; a watchdog reset comes from the program itself.
enum class ResetSource : std::uint8_t {
  kPowerOn,   ///< Supply off and on: SRAM is lost.
  kExternal,  ///< The reset pin, as by the board's DTR line: SRAM stays.
};

/// The chip that a program is for, at 16 MHz: simavr's core with our repairs, USART, two-wire
/// interface and inputs. It runs as fast as it can and never looks at a clock.
class AvrMachine {
 public:
  /// Loads `elf` and switches on at cycle 0. Throws std::runtime_error where the file cannot be
  /// read or holds no program for a chip that simavr has.
  explicit AvrMachine(const std::filesystem::path& elf);
  ~AvrMachine();
  AvrMachine(const AvrMachine&) = delete;
  AvrMachine& operator=(const AvrMachine&) = delete;

  /// Cycles since switch-on, slept ones included.
  std::uint64_t cycle() const { return avr_->cycle; }
  /// Runs to the first instruction boundary at or after `cycle`. Throws std::runtime_error where
  /// the program has crashed or sleeps for ever.
  void run_to(std::uint64_t cycle);
  /// Called before every instruction with its address in bytes, where it is set; the machine then
  /// takes ten times as long.
  std::function<void(std::uint32_t)> on_instruction;
  void reset(ResetSource source);
  /// Called after every reset, whatever its cause, before the first instruction.
  std::function<void()> on_reset;

  std::uint8_t data_at(std::uint16_t address) const { return avr_->data[address]; }
  avr_t& core() { return *avr_; }
  const avr_t& core() const { return *avr_; }
  CycleQueue& queue() { return queue_; }
  RegisterHooks& hooks() { return hooks_; }
  InputPins& pins() { return pins_; }
  AnalogInputs& analog() { return analog_; }
  Usart0& usart() { return usart_; }
  TwoWire& two_wire() { return two_wire_; }
  /// How often the chip has been reset since switch-on, by whatever cause.
  std::uint32_t resets() const { return resets_; }

 private:
  struct Terminate {
    void operator()(avr_t* avr) const;
  };

  static std::unique_ptr<avr_t, Terminate> load(const std::filesystem::path& elf);
  void after_reset();
  void run_some();
  void check_alive() const;

  std::unique_ptr<avr_t, Terminate> avr_;
  RegisterHooks hooks_;
  CycleQueue queue_;
  InputPins pins_;
  AnalogInputs analog_;
  Usart0 usart_;
  TwoWire two_wire_;
  ResetWatcher reset_watcher_;
  std::uint32_t resets_ = 0;
};

}  // namespace echomap::emulator
