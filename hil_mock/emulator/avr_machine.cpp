// SPDX-License-Identifier: GPL-3.0-or-later
#include "hil_mock/emulator/avr_machine.hpp"

#include <algorithm>
#include <avr_uart.h>
#include <cstdarg>
#include <cstdlib>
#include <sim_io.h>
#include <sim_regbit.h>
#include <stdexcept>
#include <string>

#include "hil_mock/emulator/elf_program.hpp"
#include "hil_mock/emulator/simavr_repairs.hpp"

namespace echomap::emulator {
namespace {

/// Most cycles in one call of avr_run; one instruction at a time is twice slower.
constexpr avr_cycle_count_t kRunCycleLimit = 1000;
constexpr std::uint32_t kSupplyMillivolts = 5000;
/// SRAM is random after power-on; a fixed pattern that is no useful value keeps runs the same.
constexpr std::uint8_t kPowerOnSram = 0xA5;

void ignore_log(avr_t* /*avr*/, int /*level*/, const char* /*format*/, std::va_list /*values*/) {}

/// Waits for nothing, and wakes in the cycle of the next event: simavr adds one to `cycles`, and
/// that made a wake-up late, but for one that another event came right before.
void sleep_exactly(avr_t* avr, avr_cycle_count_t cycles) {
  if (cycles != 0) {
    --avr->cycle;
  }
}

void fill_sram(avr_t& avr) {
  std::fill(avr.data + avr.ioend + 1, avr.data + avr.ramend + 1, kPowerOnSram);
}

}  // namespace

void AvrMachine::Terminate::operator()(avr_t* avr) const {
  avr_terminate(avr);
  std::free(avr);
}

std::unique_ptr<avr_t, AvrMachine::Terminate> AvrMachine::load(const std::filesystem::path& elf) {
  avr_global_logger_set(&ignore_log);
  const std::string chip = chip_of_elf(elf);
  std::unique_ptr<avr_t, Terminate> avr(avr_make_mcu_by_name(chip.c_str()));
  if (!avr) {
    throw std::runtime_error(elf.string() + ": is for an " + chip + ", which simavr does not know");
  }
  avr_init(avr.get());
  load_elf_program(elf, *avr);
  avr->frequency = kClockHz;
  avr->vcc = avr->avcc = avr->aref = kSupplyMillivolts;
  avr->sleep = &sleep_exactly;
  return avr;
}

AvrMachine::AvrMachine(const std::filesystem::path& elf)
    : avr_(load(elf)),
      hooks_(*avr_),
      queue_(*avr_),
      pins_(*avr_),
      analog_(*avr_, hooks_),
      usart_(*avr_, hooks_, queue_),
      two_wire_(*avr_, hooks_, queue_),
      reset_watcher_(*avr_, [this] { after_reset(); }) {
  repair_pin_change(*avr_);
  repair_flag_clearing(*avr_, hooks_);
  repair_late_enable(*avr_, hooks_);
  repair_interrupt_entry_time(*avr_);
  repair_watchdog(*avr_, queue_);
  reset(ResetSource::kPowerOn);
  resets_ = 0;
}

AvrMachine::~AvrMachine() {
  avr_.reset();  // simavr lets go of the hooks while they are alive
}

void AvrMachine::run_to(std::uint64_t cycle) {
  if (avr_->cycle >= cycle) {
    return;
  }
  // Two, for a sleep that begins at `cycle` itself: simavr looks for its end behind the first.
  queue_.at(cycle, [] {});
  queue_.at(cycle + 1, [] {});
  while (avr_->cycle < cycle) {
    run_some();
    check_alive();
  }
}

void AvrMachine::run_some() {
  avr_->run_cycle_limit = on_instruction ? 1 : kRunCycleLimit;
  if (on_instruction && avr_->state == cpu_Running) {
    avr_->run_cycle_count = 1;
    on_instruction(avr_->pc);
  }
  avr_run(avr_.get());
}

void AvrMachine::reset(ResetSource source) {
  avr_reset(avr_.get());
  if (source == ResetSource::kPowerOn) {
    fill_sram(*avr_);
  }
  avr_->data[avr_->reset_flags.porf.reg] = 0;
  avr_regbit_set(
      avr_.get(),
      source == ResetSource::kPowerOn ? avr_->reset_flags.porf : avr_->reset_flags.extrf);
}

void AvrMachine::after_reset() {
  ++resets_;
  queue_.rearm();
  pins_.redrive();
  usart_.reset();
  two_wire_.reset();
  if (on_reset) {
    on_reset();
  }
}

void AvrMachine::check_alive() const {
  if (avr_->state == cpu_Running || avr_->state == cpu_Sleeping) {
    return;
  }
  const char* const why = avr_->state == cpu_Done ? "sleeps with interrupts off" : "has crashed";
  throw std::runtime_error("the emulated program " + std::string(why) + " at flash address " +
                           std::to_string(avr_->pc));
}

}  // namespace echomap::emulator
