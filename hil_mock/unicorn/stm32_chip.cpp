// SPDX-License-Identifier: GPL-2.0-or-later
#include "hil_mock/unicorn/stm32_chip.hpp"

#include <stdexcept>
#include <utility>

namespace echomap::unicorn {
namespace {

constexpr std::uint32_t kFlashAddress = FlashWriter::kFlashAddress;
constexpr std::uint32_t kRamAddress = 0x20000000;
constexpr std::uint32_t kRamBytes = 0x5000;
constexpr std::uint32_t kPeripherals = 0x40000000;
constexpr std::uint32_t kPeripheralBytes = 0x24000;
constexpr std::uint32_t kBlockBytes = 0x400;
constexpr std::uint32_t kCoreRegisters = 0xE000E000;
constexpr std::uint32_t kCoreRegisterBytes = 0x1000;
constexpr std::uint32_t kSysTick = 0xE000E010;
constexpr std::uint32_t kSysTickEnd = 0xE000E020;
constexpr std::uint32_t kIcsr = 0xE000ED04;
constexpr std::uint32_t kIcsrTickPending = bit(26);
constexpr std::uint32_t kAircr = 0xE000ED0C;
constexpr std::uint32_t kAircrResetRequest = 0x05FA0000 | bit(2);

constexpr std::uint8_t kTim1UpdateLine = 25;
constexpr std::uint8_t kTim1CaptureLine = 27;
constexpr std::uint8_t kTim2Line = 28;
constexpr std::uint8_t kTim3Line = 29;
constexpr std::uint8_t kTim4Line = 30;
/// Of port B: RM0008, table 55.
constexpr std::uint8_t kI2c2ClockPin = 10;
constexpr std::uint8_t kI2c2DataPin = 11;

/// RAM is random after power-on; a fixed pattern that is no useful value keeps runs the same.
constexpr std::uint8_t kPowerOnRam = 0xA5;

}  // namespace

Stm32Chip::Stm32Chip(const std::filesystem::path& elf)
    : tim1_(queue_, nvic_, {kTim1UpdateLine, kTim1CaptureLine, true}),
      tim2_(queue_, nvic_, {kTim2Line, kTim2Line}),
      tim3_(queue_, nvic_, {kTim3Line, kTim3Line}),
      tim4_(queue_, nvic_, {kTim4Line, kTim4Line}),
      flash_(queue_) {
  using Bus = Rcc::Bus;
  blocks_ = {{0x40000000, &tim2_, Bus::kApb1, 0},
             {0x40000400, &tim3_, Bus::kApb1, 1},
             {0x40000800, &tim4_, Bus::kApb1, 2},
             {0x40002C00, &wwdg_, Bus::kApb1, 11},
             {0x40003000, &iwdg_},
             {0x40005800, &i2c2_, Bus::kApb1, 22},
             {0x40010000, &afio_, Bus::kApb2, 0},
             {0x40010400, &exti_},
             {0x40010800, &port_a_, Bus::kApb2, 2},
             {0x40010C00, &port_b_, Bus::kApb2, 3},
             {0x40012400, &adc_, Bus::kApb2, 9},
             {0x40012C00, &tim1_, Bus::kApb2, 11},
             {0x40013800, &usart_, Bus::kApb2, 14},
             {0x40021000, &rcc_},
             {0x40022000, &flash_}};
  tim1_.on_preload_taken = tim3_.on_preload_taken = [this] {
    if (on_write) {
      on_write();
    }
  };
  iwdg_.on_timeout = [this] {
    program_resets_ = ResetSource::kWatchdog;
    core_.interrupt();
  };
  wwdg_.on_timeout = [this] {
    program_resets_ = ResetSource::kWindowWatchdog;
    core_.interrupt();
  };
  i2c2_.has_pins = [this] {
    return port_b_.is_alternate(kI2c2ClockPin) && port_b_.is_alternate(kI2c2DataPin);
  };
  afio_.on_remap = [this] {
    port_a_.take_away(afio_.jtag_pins_of_a());
    port_b_.take_away(afio_.jtag_pins_of_b());
    feed_timers();
  };
  port_a_.on_change = [this](std::uint8_t pin, bool high) { on_pin(kPortA, pin, high); };
  port_b_.on_change = [this](std::uint8_t pin, bool high) { on_pin(kPortB, pin, high); };
  map();
  load(elf);
  reset(ResetSource::kPowerOn);
  resets_ = 0;
}

void Stm32Chip::load(const std::filesystem::path& elf) {
  for (const ProgramSegment& segment : read_elf_program(elf)) {
    const std::uint64_t end = std::uint64_t{segment.address} + segment.bytes.size();
    if (segment.address < kFlashAddress || end > FlashWriter::kDataAddress) {
      throw std::runtime_error(elf.string() + ": holds no program that fits into the flash");
    }
    core_.write_memory(segment.address, segment.bytes);
  }
}

void Stm32Chip::map() {
  core_.map_rom(kFlashAddress, FlashWriter::kDataAddress - kFlashAddress);
  core_.map_ram(kRamAddress, kRamBytes);
  peripherals_.read = [this](std::uint32_t address, unsigned) { return read(address); };
  peripherals_.write = [this](std::uint32_t address, unsigned, std::uint32_t value) {
    write(address, value);
  };
  core_.map_device(kPeripherals, kPeripheralBytes, peripherals_);
  core_registers_.read = [this](std::uint32_t address, unsigned) { return read_core(address); };
  core_registers_.write = [this](std::uint32_t address, unsigned size, std::uint32_t value) {
    write_core(address, size, value);
  };
  core_.map_device(kCoreRegisters, kCoreRegisterBytes, core_registers_);
  flash_data_.read = [this](std::uint32_t address, unsigned size) {
    return flash_.read_data(address - FlashWriter::kDataAddress, size);
  };
  flash_data_.write = [this](std::uint32_t address, unsigned size, std::uint32_t value) {
    flash_.write_data(address - FlashWriter::kDataAddress, size, value);
  };
  core_.map_device(FlashWriter::kDataAddress, FlashWriter::kDataBytes, flash_data_);
}

void Stm32Chip::run_to(std::uint64_t cycle) {
  while (queue_.now() < cycle) {
    core_.run_to(cycle);
    if (!refused_.empty()) {
      throw std::runtime_error(refused_);
    }
    if (const auto source = std::exchange(program_resets_, std::nullopt)) {
      reset(*source);
    }
  }
}

void Stm32Chip::reset(ResetSource source) {
  if (source == ResetSource::kPowerOn) {
    core_.write_memory(kRamAddress, std::vector<std::uint8_t>(kRamBytes, kPowerOnRam));
  }
  for (const Block& block : blocks_) {
    block.peripheral->reset();
  }
  sys_tick_.reset();
  nvic_.reset();
  rcc_.note_reset(source);
  set_pace();
  core_.reset();
  ++resets_;
  if (on_reset) {
    on_reset();
  }
}

void Stm32Chip::set_cycles_per_half_word(unsigned cycles) {
  cycles_per_half_word_ = cycles;
  set_pace();
}

void Stm32Chip::on_pin(PortName port, std::uint8_t pin, bool high) {
  feed_timers();
  if (afio_.port_of_line(pin) == port) {
    exti_.take_edge(pin, high);
  }
  if (port == kPortB && pin == kI2c2ClockPin && high && held_clocks_ != 0) {
    clock_held_device();
  }
  if (on_level) {
    on_level(port, pin, high);
  }
}

/// Inputs of the timers: RM0008, tables 43 to 46.
void Stm32Chip::feed_timers() {
  const bool remapped = afio_.tim2_is_on_a15_and_b3();
  tim1_.set_input(1, port_a_.level(8));
  tim2_.set_input(1, port_a_.level(remapped ? 15 : 0));
  tim2_.set_input(2, remapped ? port_b_.level(3) : port_a_.level(1));
  tim4_.set_input(1, port_b_.level(6));
  tim4_.set_input(2, port_b_.level(7));
}

void Stm32Chip::hold_two_wire_bus(unsigned clocks) {
  held_clocks_ = clocks;
  i2c2_.hold(true);
  port_b_.drive(kI2c2DataPin, false);
}

void Stm32Chip::clock_held_device() {
  if (--held_clocks_ == 0) {
    port_b_.drive(kI2c2DataPin, true);
    i2c2_.hold(false);
  }
}

Peripheral* Stm32Chip::answering(std::uint32_t address) {
  for (const Block& block : blocks_) {
    if (address - block.address < kBlockBytes) {
      return rcc_.clocks(block.bus, block.clock) ? block.peripheral : nullptr;
    }
  }
  refuse("uses a peripheral that is not emulated", address);
  return nullptr;
}

std::uint32_t Stm32Chip::read(std::uint32_t address) {
  queue_.call_due();
  Peripheral* const peripheral = answering(address);
  return peripheral != nullptr ? peripheral->read(address % kBlockBytes) : 0;
}

void Stm32Chip::write(std::uint32_t address, std::uint32_t value) {
  queue_.call_due();
  if (Peripheral* const peripheral = answering(address)) {
    peripheral->write(address % kBlockBytes, value);
    set_pace();
    if (on_write) {
      on_write();
    }
  }
}

std::uint32_t Stm32Chip::read_core(std::uint32_t address) {
  queue_.call_due();
  if (address >= kSysTick && address < kSysTickEnd) {
    return sys_tick_.read(address - kSysTick);
  }
  if (address == kIcsr) {
    return nvic_.sys_tick_pends() ? kIcsrTickPending : 0;
  }
  return nvic_.read(address);
}

void Stm32Chip::write_core(std::uint32_t address, unsigned size, std::uint32_t value) {
  queue_.call_due();
  if (address >= kSysTick && address < kSysTickEnd) {
    sys_tick_.write(address - kSysTick, value);
  } else if (address == kAircr) {
    if (value == kAircrResetRequest) {
      program_resets_ = ResetSource::kSoftware;
      core_.interrupt();
    }
  } else if (size == 1) {  // a priority
    const std::uint32_t word = address & ~3U;
    const std::uint32_t shift = 8 * (address % 4);
    nvic_.write(word, (nvic_.read(word) & ~(0xFFU << shift)) | value << shift);
  } else {
    nvic_.write(address, value);
  }
}

void Stm32Chip::set_pace() { core_.set_half_word_cycles(rcc_.cpu_cycle() * cycles_per_half_word_); }

void Stm32Chip::refuse(const std::string& what, std::uint32_t address) {
  refused_ = "the emulated program " + what + ", at address " + std::to_string(address);
  core_.interrupt();
}

}  // namespace echomap::unicorn
