// SPDX-License-Identifier: MIT
#include "tests/hil/measure/control_delay.hpp"

#include <algorithm>

#include "hil_mock/emulator/board_wiring.hpp"
#include "hil_mock/emulator/output_pins.hpp"
#include "tests/hil/measure/cycles.hpp"

namespace echomap::tests {
namespace {

/// Instructions of one sampling are no farther apart, whatever interrupts come in between.
constexpr std::uint64_t kOneSamplingCycles = 400;

}  // namespace

ControlDelay::ControlDelay(emulator::SimavrBoard& board, const std::filesystem::path& elf)
    : machine_(board.machine()), lines_(elf) {
  machine_.on_instruction = [this](std::uint32_t address) { note_instruction(address); };
  const avr_t& core = machine_.core();
  const emulator::BoardWiring& wiring = board.wiring();
  for (const emulator::MotorWiring& motor : {wiring.left_motor, wiring.right_motor}) {
    const emulator::DriverPin& pwm = motor.front().pwm;
    const emulator::CompareUnit unit{pwm.timer, pwm.unit, pwm.pin};
    machine_.hooks().after_write(emulator::PwmOutput(core, unit).compare_address(),
                                 [this] { note_duty(); });
  }
}

void ControlDelay::stop() { machine_.on_instruction = nullptr; }

void ControlDelay::note_instruction(std::uint32_t address) {
  const bool in_interrupt = machine_.core().interrupts.running_ptr != 0;
  if (in_interrupt || lines_.file_at(address) != "firmware/boards/edge_counter/edge_counter.cpp") {
    return;
  }
  if (!sampled_ || machine_.cycle() - newest_sampling_cycle_ > kOneSamplingCycles) {
    sampled_ = true;
    sample_cycle_ = machine_.cycle();
  }
  newest_sampling_cycle_ = machine_.cycle();
}

void ControlDelay::note_duty() {
  if (!sampled_ || !machine_.on_instruction) {
    return;
  }
  sampled_ = false;
  const double delay_us = double(machine_.cycle() - sample_cycle_) / kCyclesPerUs;
  ++duties_;
  sum_us_ += delay_us;
  max_us_ = std::max(max_us_, delay_us);
}

}  // namespace echomap::tests
