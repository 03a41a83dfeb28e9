// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "hil_mock/unicorn/adc.hpp"
#include "hil_mock/unicorn/afio.hpp"
#include "hil_mock/unicorn/cortex_core.hpp"
#include "hil_mock/unicorn/elf_program.hpp"
#include "hil_mock/unicorn/event_queue.hpp"
#include "hil_mock/unicorn/exti.hpp"
#include "hil_mock/unicorn/flash_writer.hpp"
#include "hil_mock/unicorn/gpio_port.hpp"
#include "hil_mock/unicorn/i2c.hpp"
#include "hil_mock/unicorn/iwdg.hpp"
#include "hil_mock/unicorn/nvic.hpp"
#include "hil_mock/unicorn/rcc.hpp"
#include "hil_mock/unicorn/sys_tick.hpp"
#include "hil_mock/unicorn/timer.hpp"
#include "hil_mock/unicorn/usart.hpp"
#include "hil_mock/unicorn/wwdg.hpp"

namespace echomap::unicorn {

/// Cycles of the emulated chip in a second of simulated time.
constexpr std::uint64_t kClockHz = 72'000'000;

/// Cost of a half-word of code in cycles of the CPU. Most instructions have one half-word and take
/// one cycle (Cortex-M3 technical reference manual, section 3.3) from a memory that keeps up.
constexpr unsigned kMinCyclesPerHalfWord = 1;
/// Two more, as if the prefetch buffer never hid one of the flash's two wait states at 72 MHz (ST
/// PM0075, section 3.1): what branches and loads take beyond a cycle is less than that on average.
constexpr unsigned kPessimisticCyclesPerHalfWord = 3;

/// An STM32F103 at 72 MHz: those of its parts that the firmware uses, as ST's manual describes
/// them, and the 32 kB of flash of the C6: a program that looks at more of a C8 crashes. It runs as
/// fast as it can and never looks at a clock.
class Stm32Chip {
 public:
  enum PortName : std::uint8_t { kPortA, kPortB };

  /// Loads `elf` and switches on at cycle 0. Throws std::runtime_error where the file cannot be
  /// read or holds no program for this chip.
  explicit Stm32Chip(const std::filesystem::path& elf);
  Stm32Chip(const Stm32Chip&) = delete;
  Stm32Chip& operator=(const Stm32Chip&) = delete;

  std::uint64_t cycle() const { return queue_.now(); }
  /// Runs to the first block of code that begins at or after `cycle`. Throws std::runtime_error
  /// where the program has crashed.
  void run_to(std::uint64_t cycle);
  void reset(ResetSource source);
  /// What a half-word of code costs from now on; kMinCyclesPerHalfWord before.
  void set_cycles_per_half_word(unsigned cycles);

  EventQueue& queue() { return queue_; }
  CortexCore& core() { return core_; }
  GpioPort& port(PortName name) { return name == kPortA ? port_a_ : port_b_; }
  const GpioPort& port(PortName name) const { return name == kPortA ? port_a_ : port_b_; }
  Usart& usart() { return usart_; }
  Adc& adc() { return adc_; }
  /// A device on I2C2's pins was cut off and holds SDA low for so many more clocks.
  void hold_two_wire_bus(unsigned clocks);
  I2c& i2c2() { return i2c2_; }
  const FlashWriter& flash() const { return flash_; }
  const Afio& afio() const { return afio_; }
  SysTick& sys_tick() { return sys_tick_; }
  Timer& tim2() { return tim2_; }
  Timer& tim4() { return tim4_; }
  const Timer& tim1() const { return tim1_; }
  const Timer& tim3() const { return tim3_; }
  /// Called when the level of a pin has changed, by the outside or by the program.
  std::function<void(PortName port, std::uint8_t pin, bool high)> on_level;
  /// Called when the program has written to a peripheral, and when a timer takes over what it
  /// wrote.
  std::function<void()> on_write;
  /// Called after every reset, whatever its cause, before the first instruction.
  std::function<void()> on_reset;
  /// How often the chip has been reset since switch-on, by whatever cause.
  std::uint32_t resets() const { return resets_; }

 private:
  /// A kilobyte of addresses, and the clock without which nothing answers there.
  struct Block {
    std::uint32_t address;
    Peripheral* peripheral;
    Rcc::Bus bus = Rcc::Bus::kAlwaysOn;
    std::uint8_t clock = 0;
  };

  void load(const std::filesystem::path& elf);
  void map();
  void on_pin(PortName port, std::uint8_t pin, bool high);
  void feed_timers();
  void clock_held_device();
  Peripheral* answering(std::uint32_t address);
  std::uint32_t read(std::uint32_t address);
  void write(std::uint32_t address, std::uint32_t value);
  std::uint32_t read_core(std::uint32_t address);
  void write_core(std::uint32_t address, unsigned size, std::uint32_t value);
  void set_pace();
  void refuse(const std::string& what, std::uint32_t address);

  EventQueue queue_;
  Nvic nvic_;
  Rcc rcc_{queue_};
  GpioPort port_a_;
  GpioPort port_b_;
  Afio afio_;
  Exti exti_{nvic_};
  Timer tim1_;
  Timer tim2_;
  Timer tim3_;
  Timer tim4_;
  Usart usart_{queue_, nvic_};
  Adc adc_{queue_};
  I2c i2c2_{queue_, nvic_};
  Iwdg iwdg_{queue_};
  Wwdg wwdg_{queue_, nvic_};
  FlashWriter flash_;
  SysTick sys_tick_{queue_, nvic_};
  std::vector<Block> blocks_;
  CortexCore::Device peripherals_;
  CortexCore::Device core_registers_;
  CortexCore::Device flash_data_;
  CortexCore core_{queue_, nvic_};
  unsigned cycles_per_half_word_ = kMinCyclesPerHalfWord;
  unsigned held_clocks_ = 0;
  std::optional<ResetSource> program_resets_;
  std::string refused_;
  std::uint32_t resets_ = 0;
};

}  // namespace echomap::unicorn
